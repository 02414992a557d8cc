package org.trigrid.spacing

/**
 * Sizes that pass smoothly from the spacing of one boundary to that of the next: linear in each triangle of the domain's
 * constrained Delaunay triangulation, from sizes at its nodes that already keep the gradation.
 *
 * A triangle far longer than wide can still hold a slope above the gradation; there the cones of [cones] rule where they
 * are lower. A place outside of the domain has the size of the nearest place of the triangle where the walk ended.
 */
internal class LinearField(
    private val mesh: ConstrainedDelaunay,
    /** Per node; keeps the gradation between any two nodes. */
    private val sizes: DoubleArray,
    private val cones: ConeTree,
    gradation: Double,
) : SizeField {
    private val walk = TriangleWalk(mesh)
    private var lastSource = -1
    private val steep = java.util.BitSet(mesh.triangleCount)

    override var lastHint: Int = 0
        private set

    init {
        for (t in 0 until mesh.triangleCount) if (slopeIn(t) > gradation * (1 + 1e-9)) steep.set(t)
    }

    override fun hintOf(node: Int): Int = Math.max(0, mesh.edgeOfNode[node]) / 3

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val t = walk.find(x, y, if (hint >= 0) hint else lastHint)
        lastHint = t
        val size = interpolated(t)
        if (!steep.get(t)) return size
        val limited = cones.min(x, y, lastSource, size, GradedField.TOLERANCE)
        if (cones.winner >= 0) lastSource = cones.winner
        return limited
    }

    private fun interpolated(t: Int): Double {
        val a = sizes[mesh.nodes[3 * t]]
        val b = sizes[mesh.nodes[3 * t + 1]]
        val c = sizes[mesh.nodes[3 * t + 2]]
        val u = Math.max(0.0, walk.weight0)
        val v = Math.max(0.0, walk.weight1)
        val w = Math.max(0.0, walk.weight2)
        val sum = u + v + w
        val mean = (u * a + v * b + w * c) / sum
        return if (sum > 0) mean else Math.min(a, Math.min(b, c))
    }

    /** Slope of the linear interpolation in triangle [t]; infinity where rounding leaves the triangle no area. */
    private fun slopeIn(t: Int): Double {
        val a = mesh.nodes[3 * t]
        val b = mesh.nodes[3 * t + 1]
        val c = mesh.nodes[3 * t + 2]
        val bx = mesh.xy[2 * b] - mesh.xy[2 * a]
        val by = mesh.xy[2 * b + 1] - mesh.xy[2 * a + 1]
        val cx = mesh.xy[2 * c] - mesh.xy[2 * a]
        val cy = mesh.xy[2 * c + 1] - mesh.xy[2 * a + 1]
        val hb = sizes[b] - sizes[a]
        val hc = sizes[c] - sizes[a]
        if (hb == 0.0 && hc == 0.0) return 0.0
        val det = bx * cy - by * cx
        val slope = Math.hypot(hb * cy - hc * by, hc * bx - hb * cx) / det
        return if (slope >= 0) slope else Double.POSITIVE_INFINITY
    }
}
