package org.trigrid.front

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.MutableMesh

/**
 * The way out for an edge that no candidate fits: the front node that it sees under the largest angle.
 *
 * Every edge of a valid region has at least one front node with which it makes an empty triangle; the one seen under
 * the largest angle makes the constrained Delaunay triangle. Taking it adds no node and leaves strictly less to mesh,
 * so the front always comes to its end.
 */
internal class VisibleNode(
    private val mesh: MutableMesh,
    private val front: Front,
    private val index: FrontIndex,
    private val acceptance: Acceptance,
    private val extent: Double,
    /** Asked on the way: there may be as many candidates as the front has nodes. */
    private val checkpoint: Checkpoint,
) {
    private val candidates = CandidateList()

    /** Edges that hid the candidates before, which mostly hide the next one too. */
    private val blockers = IntArray(BLOCKERS)
    private var blockerCount = 0

    /** Corner for [edge], which must be the base edge of the acceptance tests. */
    fun find(edge: Int): Int {
        val a = front.origin[edge]
        val b = front.destination(edge)
        val xy = mesh.xy
        val ax = xy[2 * a]
        val ay = xy[2 * a + 1]
        val bx = xy[2 * b]
        val by = xy[2 * b + 1]
        val mx = 0.5 * (ax + bx)
        val my = 0.5 * (ay + by)
        val length = Math.hypot(bx - ax, by - ay)
        blockerCount = 0
        var reach = 2 * length
        while (true) {
            val whole = reach > 4 * extent
            gather(edge, mx, my, reach, ax, ay, bx, by)
            val corner = firstClear()
            // Nodes seen under a larger angle may lie in the rest of the circle. It is not searched at once: it may be as large
            // as the domain, and a little farther on there may be a node that makes it small.
            if (corner >= 0) {
                val q = front.origin[corner]
                if (whole || circleReach(ax, ay, bx, by, xy[2 * q], xy[2 * q + 1]) <= reach) return corner
            }
            check(!whole) { "no front node is visible from the edge ($ax, $ay) - ($bx, $by)" }
            reach *= 4
        }
    }

    /** The candidate seen under the largest angle that nothing hides, or -1. */
    private fun firstClear(): Int {
        while (true) {
            checkpoint.pass(STEPS_PER_CANDIDATE)
            val corner = candidates.takeBest()
            if (corner == CandidateList.EMPTY) return -1
            if (acceptance.seesBase(corner) && isClear(front.origin[corner])) return corner
        }
    }

    private fun isClear(q: Int): Boolean {
        val x = mesh.xy[2 * q]
        val y = mesh.xy[2 * q + 1]
        if (!acceptance.isClear(q, x, y, blockers, Math.min(blockerCount, BLOCKERS))) return false
        if (acceptance.isClear(q, x, y)) return true
        blockers[blockerCount++ % BLOCKERS] = acceptance.blocker
        return false
    }

    private fun gather(edge: Int, mx: Double, my: Double, reach: Double, ax: Double, ay: Double, bx: Double, by: Double) {
        index.query(mx - reach, my - reach, mx + reach, my + reach)
        candidates.clear()
        val xy = mesh.xy
        for (i in 0 until index.foundCount) {
            checkpoint.pass()
            val corner = index.found[i]
            if (corner == edge) continue
            val q = front.origin[corner]
            val qx = xy[2 * q]
            val qy = xy[2 * q + 1]
            if (!acceptance.isLeftOfBase(qx, qy)) continue
            // Cotangent of the angle at q: smaller for larger angles.
            val dot = (ax - qx) * (bx - qx) + (ay - qy) * (by - qy)
            val cross = (ax - qx) * (by - qy) - (ay - qy) * (bx - qx)
            candidates.add(corner, if (cross > 0) -dot / cross else Double.NEGATIVE_INFINITY)
        }
    }

    /** Half side of a box round the edge's middle that holds the circle through a, b, q on the left of a-b. */
    private fun circleReach(ax: Double, ay: Double, bx: Double, by: Double, qx: Double, qy: Double): Double {
        val ux = bx - ax
        val uy = by - ay
        val vx = qx - ax
        val vy = qy - ay
        val d = 2 * (ux * vy - uy * vx)
        val u2 = ux * ux + uy * uy
        val v2 = vx * vx + vy * vy
        val cx = (vy * u2 - uy * v2) / d
        val cy = (ux * v2 - vx * u2) / d
        val radius = Math.hypot(cx, cy)
        val reach = Math.hypot(cx - 0.5 * ux, cy - 0.5 * uy) + radius
        return if (reach.isNaN()) Double.POSITIVE_INFINITY else reach
    }

    private companion object {
        const val BLOCKERS = 16
        const val STEPS_PER_CANDIDATE = 16
    }
}
