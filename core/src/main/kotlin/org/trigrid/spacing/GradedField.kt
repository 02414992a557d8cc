package org.trigrid.spacing

/** Sizes that grow from the boundary's own spacing by the gradation: `min over nodes i of (h_i + g |x - x_i|)`. */
internal class GradedField(private val cones: ConeTree) : SizeField {
    override var lastHint: Int = 0
        private set

    override fun hintOf(node: Int): Int = node

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val size = cones.min(x, y, hint, Double.POSITIVE_INFINITY)
        lastHint = cones.winner
        return size
    }
}
