package org.trigrid

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.domain.Domain
import org.trigrid.domain.LaidDomain
import org.trigrid.geometry.Frame
import org.trigrid.spacing.ConstrainedDelaunay

/**
 * Whether the grid of a frame is fine enough for a domain: whether in the triangulation of the rounded nodes each
 * triangle is so high that the nodes can go back to their given places without folding it.
 *
 * Then the triangles at the given places are positive, their boundary is the domain's, and a valid domain covers no place
 * twice: so they are a triangulation of it, and rounding has changed nothing but by what the grid is fine.
 */
internal class FrameSafety(private val laid: LaidDomain, private val frame: Frame, private val checkpoint: Checkpoint) {
    /** The triangulation of the rounded domain without its lone points, or null where the domain is not to be meshed in its frame. */
    fun triangulation(): ConstrainedDelaunay? {
        val domain = laid.domain
        val plain = domain.withoutLonePoints()
        val triangulation = highTriangulation(plain) ?: return null
        return if (plain === domain || highTriangulation(domain) != null) triangulation else null
    }

    private fun highTriangulation(domain: Domain): ConstrainedDelaunay? {
        val triangulation = try {
            ConstrainedDelaunay.of(domain, checkpoint)
        } catch (_: InvalidDomainException) {
            return null
        }
        return if (isHigh(triangulation)) triangulation else null
    }

    private fun isHigh(triangulation: ConstrainedDelaunay): Boolean {
        for (node in triangulation.edgeOfNode.indices) if (triangulation.edgeOfNode[node] < 0) return false
        val least = LEAST_STEPS * frame.step
        for (t in 0 until triangulation.triangleCount) {
            checkpoint.pass()
            val a = triangulation.nodes[3 * t]
            val b = triangulation.nodes[3 * t + 1]
            val c = triangulation.nodes[3 * t + 2]
            val longest = Math.max(square(triangulation, a, b), Math.max(square(triangulation, b, c), square(triangulation, c, a)))
            val twiceArea = twiceArea(triangulation, a, b, c)
            // Height times longest side is twice the area.
            if (twiceArea * twiceArea < least * least * longest) return false
        }
        return true
    }

    private fun square(triangulation: ConstrainedDelaunay, a: Int, b: Int): Double {
        val x = triangulation.xy[2 * b] - triangulation.xy[2 * a]
        val y = triangulation.xy[2 * b + 1] - triangulation.xy[2 * a + 1]
        return x * x + y * y
    }

    private fun twiceArea(triangulation: ConstrainedDelaunay, a: Int, b: Int, c: Int): Double {
        val xy = triangulation.xy
        return (xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1]) - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a])
    }

    private companion object {
        /** Each node moves by less than one step and the height by less than four. */
        const val LEAST_STEPS = 64.0
    }
}
