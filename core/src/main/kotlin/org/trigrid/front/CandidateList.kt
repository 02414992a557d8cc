package org.trigrid.front

/** Apexes under consideration for one base edge, each with a score; a handful, taken best first. */
internal class CandidateList {
    private var corners = IntArray(32)
    private var scores = DoubleArray(32)
    private var count = 0

    fun clear() {
        count = 0
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
        var best = 0
        for (i in 1 until count) {
            if (scores[i] > scores[best] || scores[i] == scores[best] && corners[i] < corners[best]) best = i
        }
        val corner = corners[best]
        count--
        corners[best] = corners[count]
        scores[best] = scores[count]
        return corner
    }

    companion object {
        const val NEW_NODE = -1
        const val EMPTY = -2
    }
}
