package org.trigrid.shape

import java.util.Arrays

/** A curve by the rate at which its length grows with its parameter. */
internal fun interface Speed {
    /** Length per unit of the parameter at [u], >= 0. */
    fun at(u: Double): Double
}

/**
 * Arc length of a smooth piecewise curve and its inverse.
 *
 * The length is summed over cells by five-point Gauss-Legendre quadrature; a cell whose two halves disagree with it is
 * halved, so narrow bends, as at the tips of a flat ellipse, get more cells. The inverse finds the cell by bisection
 * and the place in it by Newton's method, kept inside a bracket.
 *
 * @param knots increasing parameters between which the curve is smooth.
 */
internal class ArcLength(private val speed: Speed, knots: DoubleArray) {
    private var ends = DoubleArray(64)
    private var sums = DoubleArray(64)
    private var cells = 0
    private val scale = (1 until knots.size).sumOf { gauss(knots[it - 1], knots[it]) }

    init {
        ends[0] = knots[0]
        for (i in 1 until knots.size) {
            val width = (knots[i] - knots[i - 1]) / CELLS_PER_PIECE
            for (c in 0 until CELLS_PER_PIECE) {
                val from = knots[i - 1] + c * width
                val to = if (c == CELLS_PER_PIECE - 1) knots[i] else knots[i - 1] + (c + 1) * width
                add(from, to, gauss(from, to), MAX_HALVINGS)
            }
        }
    }

    val length: Double = sums[cells]

    /** The parameter at which the length from the first knot is [s], 0..[length]. */
    fun parameterAt(s: Double): Double {
        val found = Arrays.binarySearch(sums, 0, cells + 1, s)
        if (found >= 0) return ends[found]
        val cell = Math.min(Math.max(-found - 2, 0), cells - 1)
        var low = ends[cell]
        var high = ends[cell + 1]
        val wanted = s - sums[cell]
        var u = low + (high - low) * (wanted / (sums[cell + 1] - sums[cell]))
        repeat(MAX_NEWTON_STEPS) {
            val excess = gauss(ends[cell], u) - wanted
            if (excess > 0) high = u else low = u
            val next = u - excess / speed.at(u)
            val inside = if (next > low && next < high) next else (low + high) / 2
            if (Math.abs(inside - u) <= Math.ulp(u)) return inside
            u = inside
        }
        return u
    }

    private fun add(from: Double, to: Double, whole: Double, halvings: Int) {
        val middle = (from + to) / 2
        val left = gauss(from, middle)
        val right = gauss(middle, to)
        if (halvings > 0 && Math.abs(left + right - whole) > TOLERANCE * scale) {
            add(from, middle, left, halvings - 1)
            add(middle, to, right, halvings - 1)
            return
        }
        cells++
        if (cells == ends.size) {
            ends = ends.copyOf(2 * cells)
            sums = sums.copyOf(2 * cells)
        }
        ends[cells] = to
        sums[cells] = sums[cells - 1] + whole
    }

    private fun gauss(from: Double, to: Double): Double {
        val half = (to - from) / 2
        val middle = (from + to) / 2
        var sum = W0 * speed.at(middle)
        sum += W1 * (speed.at(middle - half * X1) + speed.at(middle + half * X1))
        sum += W2 * (speed.at(middle - half * X2) + speed.at(middle + half * X2))
        return half * sum
    }

    private companion object {
        const val CELLS_PER_PIECE = 4
        const val MAX_HALVINGS = 30
        const val MAX_NEWTON_STEPS = 60

        /** Largest error of a cell, as part of the whole length. */
        const val TOLERANCE = 1e-14

        // Abscissae and weights of the five-point rule on -1..1.
        const val X1 = 0.5384693101056831
        const val X2 = 0.906179845938664
        const val W0 = 0.5688888888888889
        const val W1 = 0.47862867049936647
        const val W2 = 0.23692688505618908
    }
}
