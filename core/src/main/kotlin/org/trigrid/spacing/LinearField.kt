package org.trigrid.spacing

import java.util.BitSet
import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.HalfEdges.next

/**
 * Sizes that pass smoothly from the spacing of one boundary to that of the next: linear in each triangle of the domain's
 * constrained Delaunay triangulation, from sizes at its nodes that already keep the gradation.
 *
 * A node finer than its stretch of the boundary rules only near itself: away from it, its part in the interpolation
 * grows by the gradation up to what is [typical] of the stretch. Else two fine nodes far apart, joined by an edge of
 * the triangulation, would ask for fine elements all the way between them. In the same way a small loop rules only as
 * far as [reach]: beyond, its nodes' part grows by the gradation.
 *
 * A triangle far longer than wide can still hold a slope above the gradation; there the cones of [cones] rule where they
 * are lower. A place outside of the domain has the size of the nearest place of the triangle where the walk ended.
 */
internal class LinearField(
    private val mesh: ConstrainedDelaunay,
    /** Per node; keeps the gradation between any two nodes. */
    private val sizes: DoubleArray,
    /** Per node: the size typical of the boundary near it, in [sizes] or above. */
    private val typical: DoubleArray,
    /** Per node: the distance from which on its part grows; infinity for never. */
    private val reach: DoubleArray,
    private val cones: ConeTree,
    private val gradation: Double,
    checkpoint: Checkpoint = Checkpoint.unheard(),
) : SizeField {
    private val walk = TriangleWalk(mesh, checkpoint)
    private var lastSource = -1

    /** Of the corners of the triangle at hand, at the place at hand: what the gradation allows. */
    private var lowestCone = 0.0
    private val steep = BitSet(mesh.triangleCount)
    private val uneven = BitSet(mesh.triangleCount)

    override var lastHint: Int = 0
        private set

    init {
        for (t in 0 until mesh.triangleCount) {
            checkpoint.pass()
            if (slopeIn(t) > gradation * (1 + 1e-9)) steep.set(t)
            for (k in 3 * t..3 * t + 2) {
                val node = mesh.nodes[k]
                if (typical[node] > NOTABLE * sizes[node]) uneven.set(t)
                if (reach[node] < Math.max(distance(node, mesh.nodes[next(k)]), distance(node, mesh.nodes[next(next(k))]))) {
                    uneven.set(t)
                }
            }
        }
    }

    override fun hintOf(node: Int): Int = if (node < mesh.edgeOfNode.size) Math.max(0, mesh.edgeOfNode[node]) / 3 else -1

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val t = walk.find(x, y, if (hint >= 0) hint else lastHint)
        lastHint = t
        val size = if (uneven.get(t)) interpolated(t, x, y) else interpolated(t)
        if (!steep.get(t)) return size
        val limited = cones.min(x, y, lastSource, size, GradedField.TOLERANCE)
        if (cones.winner >= 0) lastSource = cones.winner
        return limited
    }

    private fun interpolated(t: Int): Double =
        weighted(sizes[mesh.nodes[3 * t]], sizes[mesh.nodes[3 * t + 1]], sizes[mesh.nodes[3 * t + 2]])

    private fun interpolated(t: Int, x: Double, y: Double): Double {
        lowestCone = Double.POSITIVE_INFINITY
        val a = grown(mesh.nodes[3 * t], x, y)
        val b = grown(mesh.nodes[3 * t + 1], x, y)
        val c = grown(mesh.nodes[3 * t + 2], x, y)
        return Math.min(lowestCone, weighted(a, b, c))
    }

    private fun grown(node: Int, x: Double, y: Double): Double {
        val size = sizes[node]
        val dx = x - mesh.xy[2 * node]
        val dy = y - mesh.xy[2 * node + 1]
        val distance = Math.sqrt(dx * dx + dy * dy)
        val cone = size + gradation * distance
        if (cone < lowestCone) lowestCone = cone
        val near = Math.max(size, Math.min(typical[node], cone))
        return if (distance > reach[node]) near + gradation * (distance - reach[node]) else near
    }

    private fun distance(a: Int, b: Int): Double =
        Math.hypot(mesh.xy[2 * b] - mesh.xy[2 * a], mesh.xy[2 * b + 1] - mesh.xy[2 * a + 1])

    private fun weighted(a: Double, b: Double, c: Double): Double {
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

    private companion object {
        /** Below this ratio of typical size to size the difference is not worth the distance. */
        const val NOTABLE = 1.02
    }
}
