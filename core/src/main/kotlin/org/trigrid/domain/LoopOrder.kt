package org.trigrid.domain

/**
 * Puts directed segments in the order of simple loops: each loop visits a node at most once.
 *
 * A walk that comes back to a node is split there. Where several segments leave a node, the one the walk itself took
 * goes on, else the sharpest left turn, so that loops that touch do not cross. Segments that close no loop come last, as
 * open chains. Loops come in the order of their first segments and start with them.
 */
internal class LoopOrder(
    private val xy: DoubleArray,
    /** 2 per segment: start node, end node. Not modified. */
    private val segments: IntArray,
    /** Per segment: the segment that followed it in the input, or -1. Not modified. */
    private val preferredNext: IntArray,
) {
    private val count = segments.size / 2
    private val leaving = NodeSegments.leaving(xy.size / 2, segments)
    private val directions = Directions(xy)
    private val used = BooleanArray(count)
    private val positionOnPath = IntArray(xy.size / 2).also { it.fill(-1) }
    private val path = IntArray(count)
    private val loops = ArrayList<IntArray>()
    private val chains = ArrayList<IntArray>()

    /** The segments' numbers, loop by loop. */
    fun order(): IntArray {
        for (s in 0 until count) if (!used[s]) follow(s)
        loops.sortBy { it[0] }
        chains.sortBy { it[0] }
        val order = IntArray(count)
        var filled = 0
        for (piece in loops + chains) {
            piece.copyInto(order, filled)
            filled += piece.size
        }
        return order
    }

    /** Walks from [first] until no segment goes on, cutting off a loop whenever a node comes again. */
    private fun follow(first: Int) {
        var length = 0
        var s = first
        while (s >= 0) {
            used[s] = true
            positionOnPath[segments[2 * s]] = length
            path[length++] = s
            val end = segments[2 * s + 1]
            if (positionOnPath[end] >= 0) length = cutLoop(positionOnPath[end], length)
            s = next(s)
        }
        if (length == 0) return
        chains.add(path.copyOf(length))
        for (i in 0 until length) positionOnPath[segments[2 * path[i]]] = -1
    }

    private fun cutLoop(from: Int, to: Int): Int {
        var lowest = from
        for (i in from until to) {
            positionOnPath[segments[2 * path[i]]] = -1
            if (path[i] < path[lowest]) lowest = i
        }
        val size = to - from
        loops.add(IntArray(size) { path[from + (lowest - from + it) % size] })
        return from
    }

    private fun next(s: Int): Int {
        val wanted = preferredNext[s]
        if (wanted >= 0 && !used[wanted]) return wanted
        val node = segments[2 * s + 1]
        val from = segments[2 * s]
        var best = -1
        leaving.forEachAt(node) { candidate ->
            if (!used[candidate] && (best < 0 || turnsMoreLeft(node, from, candidate, best))) best = candidate
        }
        return best
    }

    /** Whether, come to [node] from [from], segment [a] leaves further to the left than [b]. */
    private fun turnsMoreLeft(node: Int, from: Int, a: Int, b: Int): Boolean {
        val endA = segments[2 * a + 1]
        val endB = segments[2 * b + 1]
        if (!isFinite(node) || !isFinite(from) || !isFinite(endA) || !isFinite(endB)) return false
        val aBefore = directions.compare(node, endA, from) < 0
        val bBefore = directions.compare(node, endB, from) < 0
        return if (aBefore != bBefore) aBefore else directions.compare(node, endA, endB) > 0
    }

    private fun isFinite(node: Int) = xy[2 * node].isFinite() && xy[2 * node + 1].isFinite()
}
