package org.trigrid.front

import org.trigrid.mesh.MutableMesh

/**
 * The way out for an edge that no candidate fits: the front node that it sees under the largest angle.
 *
 * Every edge of a valid region has at least one front node with which it makes an empty triangle; the one seen under
 * the largest angle makes the constrained Delaunay triangle. Taking any of them adds no node and leaves strictly less
 * to mesh, so the front always comes to its end; the largest angle is looked for as far as [WIDEST] times the distance
 * at which the first one was found.
 */
internal class VisibleNode(
    private val mesh: MutableMesh,
    private val front: Front,
    private val index: FrontIndex,
    private val acceptance: Acceptance,
    private val extent: Double,
) {
    private val candidates = CandidateList()

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
        var reach = 2 * length
        while (true) {
            val whole = reach > 4 * extent
            gather(edge, mx, my, reach, ax, ay, bx, by)
            while (true) {
                val corner = candidates.takeBest()
                if (corner == CandidateList.EMPTY) break
                val q = front.origin[corner]
                if (!acceptance.seesBase(corner) || !acceptance.isClear(q, xy[2 * q], xy[2 * q + 1])) continue
                val wanted = circleReach(ax, ay, bx, by, xy[2 * q], xy[2 * q + 1])
                if (whole || wanted <= reach) return corner
                // Nodes seen under a larger angle may lie in the rest of the circle. The circle of a flat triangle may hold
                // the whole front; any visible node will do then.
                reach = Math.min(wanted, WIDEST * reach)
                gather(edge, mx, my, reach, ax, ay, bx, by)
                return firstClear() ?: corner
            }
            check(!whole) { "no front node is visible from the edge ($ax, $ay) - ($bx, $by)" }
            reach *= 4
        }
    }

    private fun firstClear(): Int? {
        val xy = mesh.xy
        while (true) {
            val corner = candidates.takeBest()
            if (corner == CandidateList.EMPTY) return null
            val q = front.origin[corner]
            if (acceptance.seesBase(corner) && acceptance.isClear(q, xy[2 * q], xy[2 * q + 1])) return corner
        }
    }

    private fun gather(edge: Int, mx: Double, my: Double, reach: Double, ax: Double, ay: Double, bx: Double, by: Double) {
        index.query(mx - reach, my - reach, mx + reach, my + reach)
        candidates.clear()
        val xy = mesh.xy
        for (i in 0 until index.foundCount) {
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
        const val WIDEST = 4.0
    }
}
