package org.trigrid.io

/** What the formats share about points and numbers. */
internal object RingPoints {
    /** x0, y0, …; without the last point if it repeats the first. */
    fun withoutRepeatedEnd(xy: DoubleArray): DoubleArray {
        val last = xy.size - 2
        val repeats = last > 0 && xy[0] == xy[last] && xy[1] == xy[last + 1]
        return if (repeats) xy.copyOf(last) else xy
    }

    /** Whether a text is a plain decimal number within the range of doubles; `toDouble` also takes "1f", "NaN", "0x1p3". */
    fun isDecimal(text: String): Boolean {
        val last = text.lastOrNull() ?: return false
        if (!last.isAsciiDigit() && last != '.') return false
        var hasDigit = false
        for (c in text) {
            if (c.isAsciiDigit()) hasDigit = true else if (c != '+' && c != '-' && c != '.' && c != 'e' && c != 'E') return false
        }
        return hasDigit && text.toDoubleOrNull()?.isFinite() == true
    }

    private fun Char.isAsciiDigit() = this in '0'..'9'
}
