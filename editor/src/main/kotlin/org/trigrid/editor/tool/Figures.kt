package org.trigrid.editor.tool

import java.util.Locale

/** Numbers as people read them, with a point in every language. */
internal object Figures {
    /** Six significant digits, without idle zeros. */
    fun length(value: Double): String = plain(value, SIGNIFICANT)

    /** In degrees, to a tenth. */
    fun angle(degrees: Double): String = String.format(Locale.ROOT, "%.1f°", if (degrees == 0.0) 0.0 else degrees)

    /** As short as it can be while it is read back as the same number. */
    fun exact(value: Double): String {
        val text = value.toString()
        return if (text.endsWith(".0")) text.dropLast(2) else text
    }

    fun count(value: Int): String = String.format(Locale.ROOT, "%,d", value).replace(',', '\u202f')

    fun plain(value: Double, digits: Int): String {
        if (!value.isFinite()) return value.toString()
        if (value == 0.0) return "0"
        val rounded = java.math.BigDecimal(value).round(java.math.MathContext(digits)).stripTrailingZeros()
        val size = rounded.precision() - rounded.scale()
        return if (size > PLAIN_LARGEST || size < PLAIN_SMALLEST) rounded.toString() else rounded.toPlainString()
    }

    private const val SIGNIFICANT = 6
    private const val PLAIN_LARGEST = 9
    private const val PLAIN_SMALLEST = -4
}
