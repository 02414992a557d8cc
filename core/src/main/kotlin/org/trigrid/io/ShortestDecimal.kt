package org.trigrid.io

/**
 * The shortest decimal that reads back as a given double: the nearest to it of all the shortest ones.
 *
 * Source: Giulietti, "The Schubfach way to render doubles" (2020), sections 8 and 9. `Double.toString` of Java 17 is
 * neither shortest nor fast, and of another form from Java 19 on, so that files would differ between versions.
 *
 * One object is used again for many numbers.
 */
internal class ShortestDecimal {
    /** The number is [digits] * 10^[exponent]. */
    var digits: Long = 0
        private set
    var exponent: Int = 0
        private set

    /** Finds the decimal of [value], which is finite and above 0. */
    fun of(value: Double) {
        val bits = value.toRawBits()
        val fraction = bits and FRACTION_MASK
        val biased = (bits ushr 52).toInt() and 0x7FF
        val c: Long
        val q: Int
        if (biased != 0) {
            c = fraction or HIDDEN_BIT
            q = biased - 1075
            if (-q in 0..52 && (c and ((1L shl -q) - 1)) == 0L) {
                integer(c shr -q)
                return
            }
        } else {
            c = fraction
            q = -1074
        }
        find(c, q, fraction == 0L && biased > 1)
    }

    private fun integer(value: Long) {
        digits = value
        exponent = 0
    }

    /** The value is [c] * 2^[q]; [closer]: the next double below is only half as far as the next above. */
    private fun find(c: Long, q: Int, closer: Boolean) {
        val k = (q * 1262611 - (if (closer) 524031 else 0)) shr 22
        val h = q + DecimalPowers.floorLog2(-k) + 1
        val high = DecimalPowers.high(-k)
        val low = DecimalPowers.low(-k)
        // The value and the ends of the interval that rounds to it, in quarters of 10^k.
        val lower = roundToOdd(high, low, (4 * c - (if (closer) 1 else 2)) shl h)
        val middle = roundToOdd(high, low, (4 * c) shl h)
        val upper = roundToOdd(high, low, (4 * c + 2) shl h)
        val odd = c and 1
        choose(lower + odd, middle, upper - odd, k)
    }

    private fun choose(lower: Long, middle: Long, upper: Long, k: Int) {
        val s = middle shr 2
        if (s >= 10) {
            val tens = s / 10
            val below = lower <= 40 * tens
            val above = 40 * tens + 40 <= upper
            if (below != above) {
                digits = if (above) tens + 1 else tens
                exponent = k + 1
                return
            }
        }
        val below = lower <= 4 * s
        val above = 4 * s + 4 <= upper
        val roundUp = if (below != above) {
            above
        } else {
            val half = 4 * s + 2
            middle > half || middle == half && s and 1 != 0L
        }
        digits = if (roundUp) s + 1 else s
        exponent = k
    }

    /** The upper 64 bits of g * [cp] / 2^64, the last bit set if anything is cut off. */
    private fun roundToOdd(high: Long, low: Long, cp: Long): Long {
        val x1 = multiplyHigh(low, cp)
        val y0 = high * cp + x1
        val carry = if (java.lang.Long.compareUnsigned(y0, x1) < 0) 1 else 0
        val y1 = multiplyHigh(high, cp) + carry
        return y1 or (if (y0 and 1L.inv() != 0L) 1L else 0L)
    }

    private fun multiplyHigh(a: Long, b: Long): Long =
        Math.multiplyHigh(a, b) + ((a shr 63) and b) + ((b shr 63) and a)

    private companion object {
        const val FRACTION_MASK = (1L shl 52) - 1
        const val HIDDEN_BIT = 1L shl 52
    }
}
