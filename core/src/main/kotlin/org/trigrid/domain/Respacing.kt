package org.trigrid.domain

import org.trigrid.diagnostics.InvalidShapeException

/** Splits each segment of a domain anew; see [Domain.respaced]. */
internal class Respacing(private val domain: Domain, private val spacing: Double, private val ratio: Double) {
    private val xy = domain.xy
    private val counts: IntArray
    private val total: Int

    init {
        checkPositive("spacing", spacing)
        checkPositive("ratio", ratio)
        counts = IntArray(domain.segmentCount) { intervals(it) }
        val sum = counts.sumOf { it.toLong() }
        if (sum > MOST_SEGMENTS) throw InvalidShapeException("spacing $spacing would make $sum segments")
        total = sum.toInt()
    }

    fun respaced(): Domain {
        val coordinates = xy.copyOf(xy.size + 2 * (total - domain.segmentCount))
        val segments = IntArray(2 * total)
        val tags = IntArray(total)
        val embedded = BooleanArray(total)
        var node = domain.nodeCount
        var made = 0
        for (s in 0 until domain.segmentCount) {
            var from = domain.segmentStart(s)
            for (k in 1..counts[s]) {
                val to = if (k == counts[s]) domain.segmentEnd(s) else node++
                if (k < counts[s]) place(coordinates, to, s, k)
                segments[2 * made] = from
                segments[2 * made + 1] = to
                tags[made] = domain.segmentTag(s)
                embedded[made++] = domain.isEmbedded(s)
                from = to
            }
        }
        return Domain(coordinates, segments, tags, embedded, domain.tags, domain.regionName)
    }

    /** From the end with the smaller coordinates, so that a line gives the same nodes in both directions. */
    private fun place(coordinates: DoubleArray, node: Int, s: Int, k: Int) {
        val a = domain.segmentStart(s)
        val b = domain.segmentEnd(s)
        val n = counts[s]
        val isForward = xy[2 * a] < xy[2 * b] || xy[2 * a] == xy[2 * b] && xy[2 * a + 1] < xy[2 * b + 1]
        val share = if (isForward) share(k, n, ratio) else share(n - k, n, 1 / ratio)
        val from = if (isForward) a else b
        val to = if (isForward) b else a
        for (axis in 0..1) {
            coordinates[2 * node + axis] = xy[2 * from + axis] + share * (xy[2 * to + axis] - xy[2 * from + axis])
        }
    }

    /** Of the length, after [k] of [n] intervals whose last is [ratio] times the first: a sum of an arithmetic progression. */
    private fun share(k: Int, n: Int, ratio: Double): Double {
        if (ratio == 1.0) return k.toDouble() / n
        val growth = (ratio - 1) / (n - 1)
        return k * (1 + growth * (k - 1) / 2) / (n * (1 + growth * (n - 1) / 2))
    }

    private fun intervals(s: Int): Int {
        val a = domain.segmentStart(s)
        val b = domain.segmentEnd(s)
        val length = Math.hypot(xy[2 * b] - xy[2 * a], xy[2 * b + 1] - xy[2 * a + 1])
        val rounded = Math.round(length / spacing)
        if (rounded > MOST_SEGMENTS) throw InvalidShapeException("spacing $spacing would make $rounded segments of segment $a-$b")
        return Math.max(1, rounded.toInt())
    }

    private fun checkPositive(name: String, value: Double) {
        if (!(value > 0) || value.isInfinite()) throw InvalidShapeException("$name must be a number above 0, not $value")
    }

    private companion object {
        const val MOST_SEGMENTS = 100_000_000
    }
}
