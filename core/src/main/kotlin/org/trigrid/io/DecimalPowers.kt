package org.trigrid.io

import java.math.BigInteger

/**
 * Powers of ten as 128-bit numbers g with 2^127 <= g < 2^128, rounded up: 10^k = g 2^(e - 127), e = floor(log2(10^k)).
 */
internal object DecimalPowers {
    private const val MIN = -292
    private const val MAX = 324
    private val high = LongArray(MAX - MIN + 1)
    private val low = LongArray(MAX - MIN + 1)

    init {
        var power = BigInteger.ONE
        for (k in 0..MAX) {
            // For k >= 0 the power itself, cut to 128 bits; for k < 0 its reciprocal.
            put(k, power, BigInteger.ONE)
            if (-k >= MIN) put(-k, BigInteger.ONE, power)
            power = power.multiply(BigInteger.TEN)
        }
    }

    fun high(k: Int): Long = high[k - MIN]

    fun low(k: Int): Long = low[k - MIN]

    /** floor(log2(10^k)) for |k| <= 1233. */
    fun floorLog2(k: Int): Int = (k * 1741647) shr 19

    private fun put(k: Int, numerator: BigInteger, denominator: BigInteger) {
        val shift = 127 - floorLog2(k)
        val n = if (shift > 0) numerator.shiftLeft(shift) else numerator
        val d = if (shift < 0) denominator.shiftLeft(-shift) else denominator
        val division = n.divideAndRemainder(d)
        val g = if (division[1].signum() == 0) division[0] else division[0].add(BigInteger.ONE)
        high[k - MIN] = g.shiftRight(64).toLong()
        low[k - MIN] = g.toLong()
    }
}
