package org.trigrid.spacing

/**
 * The in-circle test in double-double arithmetic, for the few cases that plain doubles leave open.
 *
 * Each value is an unevaluated sum of two doubles, 106 bits (Dekker 1971, Numer. Math. 18:224-242; products by fused
 * multiply-add). Says "inside" only where the error bound proves it.
 */
internal object InCircleSharp {
    /** Error of the whole determinant in double-double, as a share of the sum of its terms' absolute values, with room. */
    private const val BOUND = 1e-29

    /** Whether node d lies surely inside the circle through a, b, c, which turn anticlockwise. */
    @JvmStatic
    fun isInside(xy: DoubleArray, a: Int, b: Int, c: Int, d: Int): Boolean {
        val dx = xy[2 * d]
        val dy = xy[2 * d + 1]
        val first = Term().set(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1], dx, dy)
        val second = Term().set(xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1], xy[2 * a], xy[2 * a + 1], dx, dy)
        val third = Term().set(xy[2 * c], xy[2 * c + 1], xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], dx, dy)
        val sum = Wide()
        sum.setSum(first.value, second.value)
        sum.setSum(sum, third.value)
        return sum.high > BOUND * (first.magnitude + second.magnitude + third.magnitude)
    }

    /** `|p - d|^2 * ((q - d) x (r - d))` */
    private class Term {
        val value = Wide()
        var magnitude = 0.0

        fun set(px: Double, py: Double, qx: Double, qy: Double, rx: Double, ry: Double, dx: Double, dy: Double): Term {
            val pdx = Wide().setDifference(px, dx)
            val pdy = Wide().setDifference(py, dy)
            val qdx = Wide().setDifference(qx, dx)
            val qdy = Wide().setDifference(qy, dy)
            val rdx = Wide().setDifference(rx, dx)
            val rdy = Wide().setDifference(ry, dy)
            val lift = Wide().setSum(Wide().setProduct(pdx, pdx), Wide().setProduct(pdy, pdy))
            val left = Wide().setProduct(qdx, rdy)
            val right = Wide().setProduct(rdx, qdy)
            magnitude = lift.high * (Math.abs(left.high) + Math.abs(right.high))
            right.negate()
            value.setProduct(lift, left.setSum(left, right))
            return this
        }
    }

    /** high + low; short-lived, so that the compiler keeps it in registers. */
    private class Wide {
        var high = 0.0
        var low = 0.0

        fun negate() {
            high = -high
            low = -low
        }

        fun setDifference(a: Double, b: Double): Wide {
            val difference = a - b
            val bVirtual = a - difference
            low = (a - (difference + bVirtual)) + (bVirtual - b)
            high = difference
            return this
        }

        fun setSum(a: Wide, b: Wide): Wide {
            val sum = a.high + b.high
            val bVirtual = sum - a.high
            val error = (a.high - (sum - bVirtual)) + (b.high - bVirtual)
            return normalise(sum, error + (a.low + b.low))
        }

        fun setProduct(a: Wide, b: Wide): Wide {
            val product = a.high * b.high
            val error = Math.fma(a.high, b.high, -product)
            return normalise(product, error + (a.high * b.low + a.low * b.high))
        }

        private fun normalise(a: Double, b: Double): Wide {
            val sum = a + b
            low = b - (sum - a)
            high = sum
            return this
        }
    }
}
