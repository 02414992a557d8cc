package org.trigrid.quality

import org.trigrid.diagnostics.Checkpoint

/** Percentiles without a full sort, interpolated linearly between the two nearest ranks as NumPy does. */
internal object Percentile {
    /**
     * @param values at least one, none NaN; reordered.
     * @param percent 0..100.
     */
    fun of(values: DoubleArray, percent: Double, checkpoint: Checkpoint = Checkpoint.unheard()): Double {
        val rank = percent / 100 * (values.size - 1)
        val low = rank.toInt().coerceIn(0, values.size - 1)
        val share = rank - low
        val a = select(values, low, checkpoint)
        checkpoint.ask()
        if (low == values.size - 1 || share == 0.0) return a
        // All values above the rank are now right of it.
        var b = values[low + 1]
        for (i in low + 2 until values.size) if (values[i] < b) b = values[i]
        return if (share < 0.5) a + (b - a) * share else b - (b - a) * (1 - share)
    }

    /** Hoare's selection (1961, CACM 4:321-322) with the median of three as pivot: value of rank [k]. */
    private fun select(v: DoubleArray, k: Int, checkpoint: Checkpoint): Double {
        var low = 0
        var high = v.size - 1
        while (low < high) {
            if (high - low > LONG_RANGE) checkpoint.ask() else checkpoint.pass()
            val pivot = medianOf3(v[low], v[(low + high) ushr 1], v[high])
            var i = low
            var j = high
            while (i <= j) {
                while (v[i] < pivot) i++
                while (v[j] > pivot) j--
                if (i <= j) {
                    val swap = v[i]
                    v[i++] = v[j]
                    v[j--] = swap
                }
            }
            if (k <= j) high = j else if (k >= i) low = i else return v[k]
        }
        return v[k]
    }

    /** Values whose parting takes some microseconds. */
    private const val LONG_RANGE = 1000

    private fun medianOf3(a: Double, b: Double, c: Double): Double =
        maxOf(minOf(a, b), minOf(maxOf(a, b), c))
}
