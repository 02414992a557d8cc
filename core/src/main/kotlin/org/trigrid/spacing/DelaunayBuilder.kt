package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.geometry.InsertionOrder
import org.trigrid.geometry.Predicates

/**
 * Delaunay triangulation of points under construction, on flat arrays of half-edges.
 *
 * Triangle `t` has the half-edges 3t, 3t + 1, 3t + 2, anticlockwise. Half-edge `e` runs from node `origin[e]` to
 * `origin[next(e)]`, and `twin[e]` is the same edge seen from the triangle on its other side. The plane outside of the
 * convex hull is covered by ghost triangles that join each hull edge to one symbolic node [GHOST] at infinity, so that
 * every half-edge has a twin and no far-away vertex distorts anything.
 *
 * Insertion by splitting and Lawson's flips (1977, Mathematical Software III, 161-194). An edge is flipped only when
 * it is proved that it must be: this keeps each triangle positive and ends always. Plain doubles have to prove it, which is
 * fast on points of one circle or lattice; among nodes that are all but in line, as on a straight side that is not
 * parallel to an axis, double-doubles may, since undecided slivers there would grow into long fans.
 */
internal class DelaunayBuilder(val xy: DoubleArray, val checkpoint: Checkpoint = Checkpoint.unheard()) {
    val nodeCount: Int = xy.size / 2
    val origin = IntArray(Math.max(0, 6 * nodeCount - 6))
    val twin = IntArray(origin.size)

    /** Per half-edge: 0, or how it is a constraint; moves with the edges when they are flipped. */
    val mark = ByteArray(origin.size)

    /** Triangles so far, ghosts too. */
    var triangleCount = 0
        private set

    private var stack = IntArray(64)
    private var stackSize = 0
    private var lastTriangle = 0
    private var onEdge = NONE
    private var turn = 1

    /** Inserts all points. */
    fun insertAll() {
        val order = InsertionOrder.of(xy, checkpoint)
        moveUsableTripleFirst(order)
        startWith(order[0], order[1], order[2])
        for (i in 3 until order.size) {
            checkpoint.pass()
            insert(order[i])
        }
    }

    /** Brings the first point that is not on the line of the first two to the third place. */
    private fun moveUsableTripleFirst(order: IntArray) {
        if (order.size >= 2 && samePlace(order[0], order[1])) refuseDuplicate(order[0], order[1])
        var i = 2
        while (i < order.size && orient(order[0], order[1], order[i]) == 0.0) i++
        if (i >= order.size) throw InvalidDomainException(listOf(flat()))
        val found = order[i]
        System.arraycopy(order, 2, order, 3, i - 2)
        order[2] = found
    }

    private fun flat(): Fault {
        val x = if (nodeCount > 0) xy[0] else 0.0
        val y = if (nodeCount > 0) xy[1] else 0.0
        return Fault(FaultKind.DEGENERATE_LOOP, "all $nodeCount nodes lie on one line, there is no area", x, y, IntArray(0))
    }

    private fun startWith(first: Int, second: Int, third: Int) {
        val a = first
        val left = orient(first, second, third) > 0
        val b = if (left) second else third
        val c = if (left) third else second
        val inner = newTriangle(a, b, c)
        val ab = newTriangle(b, a, GHOST)
        val bc = newTriangle(c, b, GHOST)
        val ca = newTriangle(a, c, GHOST)
        link(inner, ab)
        link(inner + 1, bc)
        link(inner + 2, ca)
        link(ab + 1, ca + 2)
        link(bc + 1, ab + 2)
        link(ca + 1, bc + 2)
    }

    /** Returns the first half-edge of the new triangle. */
    private fun newTriangle(a: Int, b: Int, c: Int): Int {
        val e = 3 * triangleCount++
        origin[e] = a
        origin[e + 1] = b
        origin[e + 2] = c
        return e
    }

    fun link(e: Int, f: Int) {
        twin[e] = f
        twin[f] = e
    }

    private fun insert(node: Int) {
        val triangle = locate(node)
        if (onEdge == NONE) splitTriangle(3 * triangle, node) else splitEdge(onEdge, node)
        lastTriangle = triangle
        legaliseRound()
    }

    /**
     * Triangle that holds the node, found by a visibility walk that starts each step at a changing side, which makes an
     * endless cycle impossible (Devillers, Pion and Teillaud 2002, Int. J. Found. Comput. Sci. 13:181-199).
     * Sets [onEdge] where the node lies on a side.
     */
    private fun locate(node: Int): Int {
        val px = xy[2 * node]
        val py = xy[2 * node + 1]
        var e = realStart()
        var cameBy = NONE
        while (true) {
            val crossed = sideFacing(e, cameBy, px, py, node)
            if (crossed == NONE) return e / 3
            cameBy = twin[crossed]
            e = cameBy
            if (origin[previous(e)] == GHOST) {
                onEdge = NONE
                return e / 3
            }
        }
    }

    /** The side of e's triangle beyond which the place lies, or NONE; also sets [onEdge]. */
    private fun sideFacing(e: Int, cameBy: Int, px: Double, py: Double, node: Int): Int {
        onEdge = NONE
        turn = turn * 1103515245 + 12345
        var side = e
        for (k in 0 until ((turn ushr 16) and 0x7fff) % 3) side = next(side)
        for (k in 0..2) {
            if (side != cameBy) {
                val a = origin[side]
                val b = origin[next(side)]
                val sign = Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], px, py)
                if (sign < 0) return side
                if (sign == 0.0) onEdge = side
            }
            side = next(side)
        }
        if (onEdge != NONE) refuseSamePlace(e, node)
        return NONE
    }

    private fun realStart(): Int {
        val e = 3 * lastTriangle
        for (k in e..e + 2) if (origin[k] == GHOST) return twin[next(k)]
        return e
    }

    private fun splitTriangle(e: Int, p: Int) {
        val a = origin[e]
        val b = origin[e + 1]
        val c = origin[e + 2]
        val outerBc = twin[e + 1]
        val outerCa = twin[e + 2]
        val bc = newTriangle(b, c, p)
        val ca = newTriangle(c, a, p)
        origin[e + 2] = p
        link(bc, outerBc)
        link(ca, outerCa)
        link(e + 1, bc + 2)
        link(bc + 1, ca + 2)
        link(ca + 1, e + 2)
        push(e)
        push(bc)
        push(ca)
    }

    /** Splits e = a→b, with c to its left and d to its right, into four triangles at [p]. */
    private fun splitEdge(e: Int, p: Int) {
        val f = twin[e]
        val a = origin[e]
        val b = origin[f]
        val c = origin[previous(e)]
        val d = origin[previous(f)]
        val outerBc = twin[next(e)]
        val outerCa = twin[previous(e)]
        val outerAd = twin[next(f)]
        val outerDb = twin[previous(f)]
        val ca = setTriangle(3 * (e / 3), c, a, p)
        val db = setTriangle(3 * (f / 3), d, b, p)
        val bc = newTriangle(b, c, p)
        val ad = newTriangle(a, d, p)
        link(ca, outerCa)
        link(db, outerDb)
        link(bc, outerBc)
        link(ad, outerAd)
        link(ca + 1, ad + 2)
        link(ca + 2, bc + 1)
        link(bc + 2, db + 1)
        link(db + 2, ad + 1)
        push(ca)
        push(db)
        push(bc)
        push(ad)
    }

    private fun setTriangle(e: Int, a: Int, b: Int, c: Int): Int {
        origin[e] = a
        origin[e + 1] = b
        origin[e + 2] = c
        return e
    }

    /** Flips edges that face the new node until the triangulation is Delaunay again. */
    private fun legaliseRound() {
        while (stackSize > 0) {
            val e = stack[--stackSize]
            if (mustFlip(e)) {
                val f = twin[e]
                flip(e)
                push(e)
                push(previous(f))
            }
        }
    }

    /** Flips until every unconstrained edge within reach of the pushed ones is locally Delaunay. */
    fun legaliseAll(startOf: IntArray) {
        while (stackSize > 0) {
            checkpoint.pass()
            val e = stack[--stackSize]
            if (mark[e] == 0.toByte() && mustFlip(e)) {
                val f = twin[e]
                if (origin[e] != GHOST) startOf[origin[e]] = e
                if (origin[f] != GHOST) startOf[origin[f]] = f
                flip(e)
                push(e)
                push(previous(e))
                push(f)
                push(previous(f))
            }
        }
    }

    fun push(e: Int) {
        if (stackSize == stack.size) stack = stack.copyOf(2 * stackSize)
        stack[stackSize++] = e
    }

    /** Whether edge e = a→b between p (left) and q (right) is surely not locally Delaunay. */
    private fun mustFlip(e: Int): Boolean {
        val f = twin[e]
        val a = origin[e]
        val b = origin[f]
        val p = origin[previous(e)]
        val q = origin[previous(f)]
        if (p == GHOST || q == GHOST) return false
        if (a == GHOST) return orient(q, b, p) > 0
        if (b == GHOST) return orient(p, a, q) > 0
        val sign = Predicates.inCircleFiltered(
            xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * p], xy[2 * p + 1], xy[2 * q], xy[2 * q + 1],
        )
        if (sign != 0.0) return sign > 0
        return isFlat(a, b, p) && isFlat(a, b, q) && InCircleSharp.isInside(xy, a, b, p, q)
    }

    /** Whether three nodes are in line to within what rounding does to the nodes of a straight side. */
    private fun isFlat(a: Int, b: Int, c: Int): Boolean {
        val abx = xy[2 * b] - xy[2 * a]
        val aby = xy[2 * b + 1] - xy[2 * a + 1]
        val acx = xy[2 * c] - xy[2 * a]
        val acy = xy[2 * c + 1] - xy[2 * a + 1]
        return Math.abs(abx * acy - aby * acx) <= FLAT * Math.max(abx * abx + aby * aby, acx * acx + acy * acy)
    }

    /** Turns a→b with p on its left and q on its right into p–q; then e is a→q and its former twin b→p. */
    private fun flip(e: Int) {
        val f = twin[e]
        val eNext = next(e)
        val fNext = next(f)
        val p = origin[previous(e)]
        val q = origin[previous(f)]
        link(e, twin[fNext])
        link(f, twin[eNext])
        link(eNext, fNext)
        origin[eNext] = q
        origin[fNext] = p
        mark[e] = mark[fNext]
        mark[f] = mark[eNext]
        mark[eNext] = 0
        mark[fNext] = 0
    }

    fun orient(a: Int, b: Int, c: Int): Double =
        Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])

    private fun samePlace(a: Int, b: Int) = xy[2 * a] == xy[2 * b] && xy[2 * a + 1] == xy[2 * b + 1]

    private fun refuseSamePlace(e: Int, node: Int) {
        val base = 3 * (e / 3)
        for (k in base..base + 2) if (samePlace(origin[k], node)) refuseDuplicate(origin[k], node)
    }

    private fun refuseDuplicate(a: Int, b: Int): Nothing {
        val x = xy[2 * a]
        val y = xy[2 * a + 1]
        val text = "nodes ${Math.min(a, b)} and ${Math.max(a, b)} are both at ($x, $y)"
        throw InvalidDomainException(
            listOf(Fault(FaultKind.DUPLICATE_NODE, text, x, y, intArrayOf(Math.min(a, b), Math.max(a, b)))),
        )
    }

    companion object {
        const val NONE = -1

        private const val FLAT = 1e-8

        /** The symbolic node at infinity. */
        const val GHOST = -1
    }
}
