package org.trigrid.spacing

/**
 * Sizes that grow from the boundary's own spacing by the gradation: `min over nodes i of (h_i + g |x - x_i|)`, to within
 * [TOLERANCE] above.
 */
internal class GradedField(private val cones: ConeTree) : SizeField {
    override var lastHint: Int = 0
        private set

    override fun hintOf(node: Int): Int = if (node < cones.sourceCount) node else -1

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val size = cones.min(x, y, hint, Double.POSITIVE_INFINITY, TOLERANCE)
        lastHint = cones.winner
        return size
    }

    internal companion object {
        /** Share by which an answer may lie above the exact one. */
        const val TOLERANCE = 0.005
    }
}
