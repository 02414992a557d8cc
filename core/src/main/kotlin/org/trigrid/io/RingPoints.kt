package org.trigrid.io

/** What the formats share about points and numbers. */
internal object RingPoints {
    /** x0, y0, …; without the last point if it repeats the first. */
    fun withoutRepeatedEnd(xy: DoubleArray): DoubleArray {
        val last = xy.size - 2
        val repeats = last > 0 && xy[0] == xy[last] && xy[1] == xy[last + 1]
        return if (repeats) xy.copyOf(last) else xy
    }

    /**
     * The double nearest to a plain decimal number, or NaN if the text is none or leaves the range of doubles;
     * `toDouble` also takes "1f", "NaN", "0x1p3".
     */
    fun decimal(text: String): Double {
        val last = text.lastOrNull() ?: return Double.NaN
        if (!last.isAsciiDigit() && last != '.') return Double.NaN
        for (c in text) {
            if (!c.isAsciiDigit() && c != '+' && c != '-' && c != '.' && c != 'e' && c != 'E') return Double.NaN
        }
        return try {
            val value = java.lang.Double.parseDouble(text)
            if (value.isFinite()) value else Double.NaN
        } catch (_: NumberFormatException) {
            Double.NaN
        }
    }

    private fun Char.isAsciiDigit() = this in '0'..'9'
}
