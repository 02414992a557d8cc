package org.trigrid.domain

import java.math.BigDecimal

/** The signed area enclosed by directed segments, anticlockwise positive. */
internal object SignedArea {
    /** Roundings of one term and of the sum, with room to spare. */
    private const val TERM_BOUND = 8 * 1.1102230246251565e-16

    /**
     * Twice the area by the shoelace formula, relative to the first node so that an offset costs no digits.
     *
     * @param segments start and end node of each segment; not modified.
     */
    fun twice(xy: DoubleArray, segments: IntArray, from: Int, to: Int): Double {
        if (from == to) return 0.0
        val x0 = xy[2 * segments[2 * from]]
        val y0 = xy[2 * segments[2 * from] + 1]
        var sum = 0.0
        for (s in from until to) {
            val a = segments[2 * s]
            val b = segments[2 * s + 1]
            sum += (xy[2 * a] - x0) * (xy[2 * b + 1] - y0) - (xy[2 * a + 1] - y0) * (xy[2 * b] - x0)
        }
        return sum
    }

    /** Sign of the area of the segments [from] until [to]: 1, 0 or -1, exact for closed loops of finite coordinates. */
    fun sign(xy: DoubleArray, segments: IntArray, from: Int, to: Int): Int {
        if (from == to) return 0
        val x0 = xy[2 * segments[2 * from]]
        val y0 = xy[2 * segments[2 * from] + 1]
        var sum = 0.0
        var size = 0.0
        for (s in from until to) {
            val a = segments[2 * s]
            val b = segments[2 * s + 1]
            val left = (xy[2 * a] - x0) * (xy[2 * b + 1] - y0)
            val right = (xy[2 * a + 1] - y0) * (xy[2 * b] - x0)
            sum += left - right
            size += Math.abs(left) + Math.abs(right)
        }
        if (Math.abs(sum) > TERM_BOUND * (to - from + 1) * size) return if (sum > 0) 1 else -1
        return if (isFinite(xy, segments, from, to)) exactSign(xy, segments, from, to) else 0
    }

    private fun exactSign(xy: DoubleArray, segments: IntArray, from: Int, to: Int): Int {
        var sum = BigDecimal.ZERO
        for (s in from until to) {
            val a = segments[2 * s]
            val b = segments[2 * s + 1]
            sum = sum.add(BigDecimal(xy[2 * a]).multiply(BigDecimal(xy[2 * b + 1])))
            sum = sum.subtract(BigDecimal(xy[2 * a + 1]).multiply(BigDecimal(xy[2 * b])))
        }
        return sum.signum()
    }

    private fun isFinite(xy: DoubleArray, segments: IntArray, from: Int, to: Int): Boolean {
        for (i in 2 * from until 2 * to) {
            if (!xy[2 * segments[i]].isFinite() || !xy[2 * segments[i] + 1].isFinite()) return false
        }
        return true
    }
}
