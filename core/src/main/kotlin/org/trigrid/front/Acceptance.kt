package org.trigrid.front

import org.trigrid.geometry.Predicates
import org.trigrid.mesh.MutableMesh

/**
 * The topological tests that an element over a base edge must pass; signs only, no tolerance.
 *
 * The front is the boundary of what is still to be meshed, so an element with no front node in its closed triangle
 * and no front edge on its two new sides lies wholly inside.
 */
internal class Acceptance(private val mesh: MutableMesh, private val front: Front, private val index: FrontIndex) {
    private var ax = 0.0
    private var ay = 0.0
    private var bx = 0.0
    private var by = 0.0
    private var a = 0
    private var b = 0
    private var base = 0

    /** The edge in the way of the last element that was not clear. */
    var blocker = -1
        private set

    /** Sets the base edge of the tests that follow. */
    fun base(edge: Int) {
        base = edge
        a = front.origin[edge]
        b = front.destination(edge)
        ax = mesh.xy[2 * a]
        ay = mesh.xy[2 * a + 1]
        bx = mesh.xy[2 * b]
        by = mesh.xy[2 * b + 1]
    }

    fun isLeftOfBase(x: Double, y: Double): Boolean = Predicates.orient(ax, ay, bx, by, x, y) > 0

    /**
     * Whether the element of the base edge and the place ([qx], [qy]), strictly left of it, is clear of the front.
     *
     * @param q the node at that place, or -1 for a new one.
     * @param near edges to test, [nearCount] of them: all that meet the triangle's box must be among them.
     */
    fun isClear(q: Int, qx: Double, qy: Double, near: IntArray, nearCount: Int): Boolean {
        val x0 = Math.min(Math.min(ax, bx), qx)
        val x1 = Math.max(Math.max(ax, bx), qx)
        val y0 = Math.min(Math.min(ay, by), qy)
        val y1 = Math.max(Math.max(ay, by), qy)
        val xy = mesh.xy
        for (i in 0 until nearCount) {
            val edge = near[i]
            if ((index.apart(edge, x0, y0, x1, y1) < 0) or (edge == base)) continue
            blocker = edge
            val u = front.origin[edge]
            val v = front.origin[front.next[edge]]
            val ux = xy[2 * u]
            val uy = xy[2 * u + 1]
            val vx = xy[2 * v]
            val vy = xy[2 * v + 1]
            if (u != a && u != b && u != q && covers(qx, qy, ux, uy)) return false
            if (u == q || v == q) continue
            val atA = u == a || v == a
            val atB = u == b || v == b
            if (!atA && meets(ax, ay, qx, qy, ux, uy, vx, vy)) return false
            if (!atB && meets(bx, by, qx, qy, ux, uy, vx, vy)) return false
        }
        return true
    }

    /** As above, with a query of its own round the triangle. */
    fun isClear(q: Int, qx: Double, qy: Double): Boolean {
        index.query(
            Math.min(Math.min(ax, bx), qx), Math.min(Math.min(ay, by), qy),
            Math.max(Math.max(ax, bx), qx), Math.max(Math.max(ay, by), qy),
        )
        return isClear(q, qx, qy, index.found, index.foundCount)
    }

    /**
     * Whether the base edge lies in the sector of [corner]: between the edge that leaves it and, turning
     * anticlockwise, the way back along the edge that comes in. Tells the corners of one node apart. The corner's own
     * edges to the ends of the base edge may bound the sector only on the sides where the element would lie in it.
     */
    fun seesBase(corner: Int): Boolean {
        val s = front.destination(corner)
        val r = front.origin[front.previous[corner]]
        if (r == s) return true
        if (r == a || s == b) return false
        val q = front.origin[corner]
        return inSector(q, r, s, ax, ay) && inSector(q, r, s, bx, by)
    }

    private fun inSector(q: Int, r: Int, s: Int, x: Double, y: Double): Boolean {
        val xy = mesh.xy
        val qx = xy[2 * q]
        val qy = xy[2 * q + 1]
        val rx = xy[2 * r]
        val ry = xy[2 * r + 1]
        val sx = xy[2 * s]
        val sy = xy[2 * s + 1]
        val turn = Predicates.orient(rx, ry, qx, qy, sx, sy)
        val leftOfOut = Predicates.orient(qx, qy, sx, sy, x, y)
        if (turn == 0.0) return leftOfOut >= 0
        val leftOfIn = Predicates.orient(rx, ry, qx, qy, x, y)
        return if (turn > 0) leftOfOut >= 0 && leftOfIn >= 0 else leftOfOut >= 0 || leftOfIn >= 0
    }

    private fun covers(qx: Double, qy: Double, x: Double, y: Double): Boolean =
        Predicates.orient(ax, ay, bx, by, x, y) >= 0 &&
            Predicates.orient(bx, by, qx, qy, x, y) >= 0 &&
            Predicates.orient(qx, qy, ax, ay, x, y) >= 0

    /** Whether the closed segments p-q and u-v have a point in common. */
    private fun meets(
        px: Double, py: Double, qx: Double, qy: Double, ux: Double, uy: Double, vx: Double, vy: Double,
    ): Boolean {
        val pqu = Predicates.orient(px, py, qx, qy, ux, uy)
        val pqv = Predicates.orient(px, py, qx, qy, vx, vy)
        if (pqu > 0 && pqv > 0 || pqu < 0 && pqv < 0) return false
        if (pqu == 0.0 && pqv == 0.0) {
            // On one line: apart or not is told by the boxes.
            return Math.max(px, qx) >= Math.min(ux, vx) && Math.max(ux, vx) >= Math.min(px, qx) &&
                Math.max(py, qy) >= Math.min(uy, vy) && Math.max(uy, vy) >= Math.min(py, qy)
        }
        val uvp = Predicates.orient(ux, uy, vx, vy, px, py)
        val uvq = Predicates.orient(ux, uy, vx, vy, qx, qy)
        return !(uvp > 0 && uvq > 0 || uvp < 0 && uvq < 0)
    }
}
