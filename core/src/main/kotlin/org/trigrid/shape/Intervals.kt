package org.trigrid.shape

/**
 * How many intervals a length is cut into, and where the cuts lie (paper, appendix A).
 *
 * Departures from the listing: at least one interval where the listing loses a node, the nearest whole number
 * where it truncates, and closed sums where it adds up rounded steps.
 */
internal object Intervals {
    private const val MAX_COUNT = 10_000_000

    /** Allowance for rounding when an interval is compared with the spacing that is its maximum. */
    private const val SLACK = 1 + 1e-12

    /** Number of intervals for [length]; [growth] as in [fractions]. */
    fun count(length: Double, traits: Traits, growth: Double): Int {
        val wanted = length / traits.spacing
        if (!(wanted < MAX_COUNT)) {
            Traits.refuse(traits.kind, "spacing ${traits.spacing} is too small for the length $length")
        }
        if (traits.rounding == Rounding.NEAREST) return Math.max(1, Math.round(wanted).toInt())
        return leastCount(wanted * (1 / SLACK), growth, traits)
    }

    /** Least n whose longest interval is at most the spacing: [wanted] * longest fraction <= 1. */
    private fun leastCount(wanted: Double, growth: Double, traits: Traits): Int {
        var low = Math.max(1, Math.ceil(wanted).toInt())
        if (growth == 1.0 || fits(low, wanted, growth, traits)) return low
        var high = low
        while (!fits(high, wanted, growth, traits)) {
            if (high > MAX_COUNT / 2) Traits.refuse(traits.kind, "ratio ${traits.ratio} asks for too many nodes")
            low = high
            high *= 2
        }
        while (high - low > 1) {
            val middle = (low + high) ushr 1
            if (fits(middle, wanted, growth, traits)) high = middle else low = middle
        }
        return high
    }

    private fun fits(count: Int, wanted: Double, growth: Double, traits: Traits): Boolean {
        val t = fractions(count, growth, traits.distribution)
        var longest = 0.0
        for (k in 1..count) longest = Math.max(longest, t[k] - t[k - 1])
        return wanted * longest <= 1
    }

    /**
     * Places of the nodes as parts of the length, 0 to 1.
     *
     * @param growth last interval / first interval, >= 1, so that the short intervals, near 0, keep all their digits;
     *   for the symmetric distribution middle / ends, any value > 0.
     * @return size count + 1, increasing, exactly 0 first and 1 last.
     */
    fun fractions(count: Int, growth: Double, distribution: Distribution): DoubleArray {
        val t = when {
            count == 1 || growth == 1.0 -> DoubleArray(count + 1) { it.toDouble() / count }
            distribution == Distribution.LINEAR -> linear(count, growth)
            distribution == Distribution.GEOMETRIC -> geometric(count, growth)
            else -> symmetric(count, growth)
        }
        t[count] = 1.0
        return t
    }

    /** Interval c is proportional to 1 + c (r - 1) / (n - 1). */
    private fun linear(count: Int, growth: Double): DoubleArray {
        val step = (growth - 1) / (count - 1)
        val total = count * (1 + growth) / 2
        return DoubleArray(count + 1) { (it + step * (it * (it - 1.0) / 2)) / total }
    }

    /** Interval c is proportional to r^(c / (n - 1)). */
    private fun geometric(count: Int, growth: Double): DoubleArray {
        val rate = StrictMath.log(growth) / (count - 1)
        val total = StrictMath.expm1(count * rate)
        return DoubleArray(count + 1) { StrictMath.expm1(it * rate) / total }
    }

    private fun symmetric(count: Int, growth: Double): DoubleArray {
        val middle = (count - 1) / 2
        val t = DoubleArray(count + 1)
        for (c in 0 until count) {
            val fromEnd = Math.min(c, count - 1 - c)
            val length = if (middle == 0) 1.0 else 1 + fromEnd * (growth - 1) / middle
            t[c + 1] = t[c] + length
        }
        val total = t[count]
        for (k in 0..count) t[k] /= total
        return t
    }
}
