package org.trigrid.domain

import org.trigrid.geometry.Predicates
import java.util.PriorityQueue

/** Finds straight lines between nodes that meet no segment but at their ends; decided exactly. */
internal class FreeLine(
    private val xy: DoubleArray,
    /** 2 per segment: start node, end node. Not modified. */
    private val segments: IntArray,
) {
    private val tree = SegmentTree(xy, segments)

    private class Candidate(val from: Int, val to: Int, val distance: Double)

    /**
     * The nodes at the ends of the shortest free line from one of [from] to one of [to], or null if none is free. Of lines
     * of one length that from the earlier node.
     */
    fun shortest(from: IntArray, to: IntArray): IntArray? {
        val order = compareBy<Candidate> { it.distance }.thenBy { it.from }.thenBy { it.to }
        val queue = PriorityQueue(order)
        for (node in from) next(node, to, -1.0, -1)?.let { queue.add(it) }
        while (true) {
            val best = queue.poll() ?: return null
            if (isFree(best.from, best.to)) return intArrayOf(best.from, best.to)
            next(best.from, to, best.distance, best.to)?.let { queue.add(it) }
        }
    }

    /** The node of [to] nearest to [node] of those behind the one with the given distance and number. */
    private fun next(node: Int, to: IntArray, distance: Double, number: Int): Candidate? {
        var best = -1
        var least = Double.POSITIVE_INFINITY
        for (other in to) {
            val d = StrictMath.hypot(xy[2 * other] - xy[2 * node], xy[2 * other + 1] - xy[2 * node + 1])
            if (d < distance || d == distance && other <= number) continue
            if (d < least || d == least && other < best) {
                best = other
                least = d
            }
        }
        return if (best < 0) null else Candidate(node, best, least)
    }

    private fun isFree(a: Int, b: Int): Boolean {
        val minX = Math.min(xy[2 * a], xy[2 * b])
        val minY = Math.min(xy[2 * a + 1], xy[2 * b + 1])
        val maxX = Math.max(xy[2 * a], xy[2 * b])
        val maxY = Math.max(xy[2 * a + 1], xy[2 * b + 1])
        var isFree = true
        tree.forEachIn(minX, minY, maxX, maxY) { segment ->
            if (isFree && meets(a, b, segments[2 * segment], segments[2 * segment + 1])) isFree = false
        }
        return isFree
    }

    private fun meets(a: Int, b: Int, c: Int, d: Int): Boolean {
        val sideC = orient(a, b, c)
        val sideD = orient(a, b, d)
        if (c == a || c == b) return sideD == 0.0 && isAhead(c, if (c == a) b else a, d)
        if (d == a || d == b) return sideC == 0.0 && isAhead(d, if (d == a) b else a, c)
        if (sideC > 0 && sideD > 0 || sideC < 0 && sideD < 0) return false
        val sideA = orient(c, d, a)
        val sideB = orient(c, d, b)
        // In one line their boxes touch, so they do.
        return !(sideA > 0 && sideB > 0 || sideA < 0 && sideB < 0)
    }

    /** Whether [c], in one line with the others, lies on the same side of [from] as [to]. */
    private fun isAhead(from: Int, to: Int, c: Int): Boolean {
        val x = xy[2 * to] - xy[2 * from]
        val y = xy[2 * to + 1] - xy[2 * from + 1]
        return if (Math.abs(x) >= Math.abs(y)) (xy[2 * c] > xy[2 * from]) == (x > 0) else (xy[2 * c + 1] > xy[2 * from + 1]) == (y > 0)
    }

    private fun orient(a: Int, b: Int, c: Int): Double =
        Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
}
