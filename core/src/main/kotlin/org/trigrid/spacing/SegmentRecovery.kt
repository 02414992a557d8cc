package org.trigrid.spacing

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.geometry.IntList
import org.trigrid.spacing.DelaunayBuilder.Companion.GHOST
import org.trigrid.spacing.DelaunayBuilder.Companion.NONE

/**
 * Forces segments into a Delaunay triangulation and marks them.
 *
 * The triangles that a missing segment crosses are taken out; the hole falls into two polygons, each of whose nodes
 * sees the segment. In such a polygon each convex corner is an ear (Avis and Toussaint 1981, Pattern Recognition
 * 13:23-29), so it is filled by cutting ears, in rounds that spare the neighbours of the ears just cut so that the result is
 * balanced; Lawson's flips then make it constrained Delaunay.
 */
internal class SegmentRecovery(private val mesh: DelaunayBuilder) {
    private val origin = mesh.origin
    private val twin = mesh.twin
    private val mark = mesh.mark
    private val startOf = IntArray(mesh.nodeCount).apply { fill(NONE) }

    private val triangles = IntList()
    private val rightEdges = IntList()
    private val leftEdges = IntList()
    private val chain = PolygonChain()

    init {
        for (e in 0 until 3 * mesh.triangleCount) {
            mesh.checkpoint.pass()
            if (origin[e] != GHOST) startOf[origin[e]] = e
        }
    }

    /** Half-edge from [u] to [v], or NONE; costs as much as the smaller of the two nodes' degrees. */
    private fun edgeBetween(u: Int, v: Int): Int {
        var e = startOf[u]
        var f = startOf[v]
        do {
            if (origin[next(e)] == v) return e
            if (origin[next(f)] == u) return twin[f]
            e = twin[previous(e)]
            f = twin[previous(f)]
        } while (e != startOf[u] && f != startOf[v])
        return NONE
    }

    /** Marks the segment if it is an edge already; otherwise returns false. */
    fun markIfPresent(u: Int, v: Int, embedded: Boolean): Boolean {
        val e = edgeBetween(u, v)
        if (e == NONE) return false
        markEdge(e, embedded)
        return true
    }

    private fun markEdge(e: Int, embedded: Boolean) {
        val both = embedded || mark[e] == OUTSIDE
        mark[e] = if (both) EMBEDDED else INSIDE
        mark[twin[e]] = if (both) EMBEDDED else OUTSIDE
    }

    /** Makes the segment an edge and marks it. */
    fun recover(u: Int, v: Int, embedded: Boolean) {
        if (markIfPresent(u, v, embedded)) return
        collectCrossed(firstCrossed(u, v), u, v)
        check(triangles.size == rightEdges.size + leftEdges.size - 2) { "segment $u-$v crosses a broken channel" }
        leftEdges.reverse()
        chain.detach(rightEdges, leftEdges)
        val right = chain.fill(0, rightEdges.size, u, v)
        val left = chain.fill(rightEdges.size, leftEdges.size, v, u)
        mesh.link(left, right)
        markEdge(left, embedded)
        relax()
    }

    /** Flips whatever doubtful decisions on the way have left; few or none. */
    fun relaxAll() {
        for (e in 0 until 3 * mesh.triangleCount) {
            mesh.checkpoint.pass()
            if (e < twin[e] && mark[e] == NO_MARK) mesh.push(e)
        }
        mesh.legaliseAll(startOf)
    }

    private fun relax() {
        for (i in 0 until triangles.size) {
            val e = 3 * triangles[i]
            for (k in e..e + 2) startOf[origin[k]] = k
        }
        for (i in 0 until triangles.size) {
            val e = 3 * triangles[i]
            for (k in e..e + 2) mesh.push(k)
        }
        mesh.legaliseAll(startOf)
    }

    /** Half-edge u→a of the triangle at [u] through which the segment leaves. */
    private fun firstCrossed(u: Int, v: Int): Int {
        var e = startOf[u]
        do {
            val a = origin[next(e)]
            val b = origin[previous(e)]
            if (a != GHOST) {
                val side = mesh.orient(u, v, a)
                if (side == 0.0 && isAhead(u, v, a)) refuseTouching(u, v, a)
                if (side < 0 && b != GHOST && mesh.orient(u, v, b) > 0) return e
            }
            e = twin[previous(e)]
        } while (e != startOf[u])
        throw IllegalStateException("segment $u-$v leaves no triangle")
    }

    private fun isAhead(u: Int, v: Int, a: Int): Boolean {
        val xy = mesh.xy
        val forwardX = (xy[2 * a] > xy[2 * u]) == (xy[2 * v] > xy[2 * u]) && xy[2 * v] != xy[2 * u]
        val forwardY = (xy[2 * a + 1] > xy[2 * u + 1]) == (xy[2 * v + 1] > xy[2 * u + 1]) && xy[2 * v + 1] != xy[2 * u + 1]
        return forwardX || forwardY
    }

    /** Fills [triangles] with those crossed, and the half-edges of the hole on both sides of the segment, from u on. */
    private fun collectCrossed(first: Int, u: Int, v: Int) {
        triangles.clear()
        rightEdges.clear()
        leftEdges.clear()
        triangles.add(first / 3)
        rightEdges.add(first)
        leftEdges.add(previous(first))
        var e = next(first)
        while (true) {
            if (mark[e] != NO_MARK) refuseCrossing(u, v, e)
            val f = twin[e]
            triangles.add(f / 3)
            val c = origin[previous(f)]
            if (c == v) {
                rightEdges.add(next(f))
                leftEdges.add(previous(f))
                return
            }
            check(c != GHOST) { "segment $u-$v leaves the convex hull" }
            val side = mesh.orient(u, v, c)
            if (side == 0.0) refuseTouching(u, v, c)
            if (side > 0) leftEdges.add(previous(f)) else rightEdges.add(next(f))
            e = if (side > 0) next(f) else previous(f)
        }
    }

    private fun refuseTouching(u: Int, v: Int, a: Int): Nothing {
        val x = mesh.xy[2 * a]
        val y = mesh.xy[2 * a + 1]
        val text = "node $a at ($x, $y) lies on the segment of nodes $u and $v"
        throw InvalidDomainException(listOf(Fault(FaultKind.TOUCHING, text, x, y, intArrayOf(a, u, v))))
    }

    private fun refuseCrossing(u: Int, v: Int, e: Int): Nothing {
        val a = origin[e]
        val b = origin[next(e)]
        val x = 0.5 * (mesh.xy[2 * a] + mesh.xy[2 * b])
        val y = 0.5 * (mesh.xy[2 * a + 1] + mesh.xy[2 * b + 1])
        val text = "the segment of nodes $u and $v crosses that of nodes $a and $b near ($x, $y)"
        throw InvalidDomainException(listOf(Fault(FaultKind.CROSSING, text, x, y, intArrayOf(u, v, a, b))))
    }

    /** The open chains of nodes of a hole, filled by cutting ears; reuses the triangles taken out. */
    private inner class PolygonChain {
        private var outer = IntArray(16)
        private var outerMark = ByteArray(16)
        private var node = IntArray(16)
        private var before = IntArray(16)
        private var after = IntArray(16)
        private var stamp = IntArray(16)
        private var active = IntArray(16)
        private var later = IntArray(16)
        private var usedTriangles = 0

        /** Remembers what lies beyond the edges of the hole: a half-edge, or, as -(i + 2), edge i of the hole itself. */
        fun detach(right: IntList, left: IntList) {
            usedTriangles = 0
            val count = right.size + left.size
            ensure(count + 2)
            for (i in 0 until count) {
                val e = if (i < right.size) right[i] else left[i - right.size]
                outer[i] = twin[e]
                outerMark[i] = mark[e]
                node[i] = origin[e]
            }
            for (i in 0 until count) twin[if (i < right.size) right[i] else left[i - right.size]] = -(i + 2)
            for (i in 0 until count) if (twin[outer[i]] < NONE) outer[i] = twin[outer[i]]
        }

        private fun ensure(count: Int) {
            if (count <= outer.size) return
            val size = Math.max(count, 2 * outer.size)
            outer = IntArray(size)
            outerMark = ByteArray(size)
            node = IntArray(size)
            before = IntArray(size)
            after = IntArray(size)
            stamp = IntArray(size)
            active = IntArray(size)
            later = IntArray(size)
        }

        /**
         * Fills the polygon whose edges are the chain's [first] until [first] + [edges], from node [from] to node [to], and
         * the segment back. Returns the half-edge to→from.
         */
        fun fill(first: Int, edges: Int, from: Int, to: Int): Int {
            val end = first + edges
            check(node[first] == from) { "chain of segment $from-$to starts elsewhere" }
            var activeCount = 0
            for (i in first until end) {
                before[i] = i - 1
                after[i] = i + 1
                stamp[i] = 0
                if (i > first) active[activeCount++] = i
            }
            var left = edges - 1
            var round = 1
            while (left > 0) {
                var laterCount = 0
                for (k in 0 until activeCount) {
                    val i = active[k]
                    if (stamp[i] == round || stamp[i] == CUT || !isConvex(i, end, to)) continue
                    cut(i, end, to)
                    left--
                    laterCount = revisit(before[i], first, end, round, laterCount)
                    laterCount = revisit(after[i], first, end, round, laterCount)
                }
                check(laterCount > 0 || left == 0) { "no ear beside segment $from-$to" }
                val swap = active
                active = later
                later = swap
                activeCount = laterCount
                round++
            }
            return outer[first]
        }

        private fun nodeAt(i: Int, end: Int, to: Int) = if (i == end) to else node[i]

        private fun isConvex(i: Int, end: Int, to: Int) =
            mesh.orient(node[before[i]], node[i], nodeAt(after[i], end, to)) > 0

        private fun revisit(i: Int, first: Int, end: Int, round: Int, count: Int): Int {
            if (i == first || i == end || stamp[i] == round) return count
            stamp[i] = round
            later[count] = i
            return count + 1
        }

        private fun cut(i: Int, end: Int, to: Int) {
            val p = before[i]
            val q = after[i]
            val e = 3 * triangles[usedTriangles++]
            origin[e] = node[p]
            origin[e + 1] = node[i]
            origin[e + 2] = nodeAt(q, end, to)
            attach(e, p)
            attach(e + 1, i)
            mark[e + 2] = NO_MARK
            outer[p] = e + 2
            outerMark[p] = NO_MARK
            stamp[i] = CUT
            after[p] = q
            if (q != end) before[q] = p
        }

        private fun attach(e: Int, i: Int) {
            mark[e] = outerMark[i]
            if (outer[i] > NONE) mesh.link(e, outer[i]) else outer[-outer[i] - 2] = e
        }
    }

    companion object {
        const val NO_MARK: Byte = 0

        /** The half-edge is a boundary segment with the domain on its left. */
        const val INSIDE: Byte = 1

        /** The half-edge is a boundary segment backwards: the outside is on its left. */
        const val OUTSIDE: Byte = 2

        /** The edge is a segment with the domain on both sides. */
        const val EMBEDDED: Byte = 3

        private const val CUT = -1
    }
}
