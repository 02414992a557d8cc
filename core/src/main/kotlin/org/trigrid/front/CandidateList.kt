package org.trigrid.front

/** Apexes under consideration for one base edge, each with a score, taken best first: mostly a handful, on the way out thousands. */
internal class CandidateList {
    private var corners = IntArray(32)
    private var scores = DoubleArray(32)
    private var count = 0

    /** Whether the candidates are in the order of a heap, the best first. */
    private var isHeap = false

    fun clear() {
        count = 0
        isHeap = false
    }

    /** [corner] is a front corner or [NEW_NODE]. */
    fun add(corner: Int, score: Double) {
        if (count == corners.size) {
            corners = corners.copyOf(2 * count)
            scores = scores.copyOf(2 * count)
        }
        corners[count] = corner
        scores[count++] = score
    }

    /** Removes and returns the candidate with the highest score, of equal ones the lowest corner; [EMPTY] if none. */
    fun takeBest(): Int {
        if (count == 0) return EMPTY
        if (!isHeap) for (i in (count - 2) / 2 downTo 0) sink(i)
        isHeap = true
        val corner = corners[0]
        count--
        corners[0] = corners[count]
        scores[0] = scores[count]
        sink(0)
        return corner
    }

    private fun sink(start: Int) {
        val corner = corners[start]
        val score = scores[start]
        var hole = start
        while (true) {
            var below = 2 * hole + 1
            if (below >= count) break
            if (below + 1 < count && isBetter(corners[below + 1], scores[below + 1], corners[below], scores[below])) below++
            if (!isBetter(corners[below], scores[below], corner, score)) break
            corners[hole] = corners[below]
            scores[hole] = scores[below]
            hole = below
        }
        corners[hole] = corner
        scores[hole] = score
    }

    private fun isBetter(corner: Int, score: Double, other: Int, otherScore: Double) =
        score > otherScore || score == otherScore && corner < other

    companion object {
        const val NEW_NODE = -1
        const val EMPTY = -2
    }
}
