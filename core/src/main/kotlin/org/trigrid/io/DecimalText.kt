package org.trigrid.io

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode

/** Decimals of doubles as text: the shortest that reads back, or as many digits as fit a field. */
internal class DecimalText {
    private val decimal = ShortestDecimal()

    /** The shortest decimal that reads back as [value], which is finite: 0.5, 12, 1e-9; as [TextBuffer] writes it. */
    fun shortest(value: Double): String {
        if (value == 0.0) return "0"
        decimal.of(Math.abs(value))
        val sign = if (value < 0) "-" else ""
        return sign + text(decimal.digits.toString().trimEnd('0'), decimal.digits.toString().length + decimal.exponent, 'e')
    }

    /** [shortest], or where that is longer than [width] (at least 12) the nearest decimal that fits. */
    fun fitting(value: Double, width: Int): String {
        val exact = shortest(value)
        if (exact.length <= width) return exact
        return rounded(value, width) { digits, point -> text(digits, point, 'e') }
    }

    /** A real number of Nastran in [width] characters: always with a point, exponents without e, no zero before the point. */
    fun nastran(value: Double, width: Int): String {
        if (value == 0.0) return "0."
        decimal.of(Math.abs(value))
        val sign = if (value < 0) "-" else ""
        val all = decimal.digits.toString()
        val exact = sign + nastranText(all.trimEnd('0'), all.length + decimal.exponent)
        return if (exact.length <= width) exact else rounded(value, width, ::nastranText)
    }

    private fun rounded(value: Double, width: Int, format: (String, Int) -> String): String {
        val number = BigDecimal(Math.abs(value))
        val sign = if (value < 0) "-" else ""
        for (count in MOST_DIGITS downTo 1) {
            val cut = number.round(MathContext(count, RoundingMode.HALF_EVEN))
            val digits = cut.unscaledValue().toString()
            val text = sign + format(digits.trimEnd('0'), digits.length - cut.scale())
            if (text.length <= width) return text
        }
        throw IllegalArgumentException("no decimal of $value fits $width characters")
    }

    /** @param point place of the decimal point after the first digit. */
    private fun text(digits: String, point: Int, e: Char): String = when {
        point in LOWEST_POINT..0 -> "0." + "0".repeat(-point) + digits
        point in 1..HIGHEST_POINT && digits.length <= point -> digits + "0".repeat(point - digits.length)
        point in 1..HIGHEST_POINT -> digits.take(point) + "." + digits.drop(point)
        else -> digits.take(1) + (if (digits.length > 1) "." + digits.drop(1) else "") + e + (point - 1)
    }

    private fun nastranText(digits: String, point: Int): String {
        val plain = when {
            point in NASTRAN_POINTS && digits.length <= point -> digits + "0".repeat(point - digits.length) + "."
            point in NASTRAN_POINTS && point > 0 -> digits.take(point) + "." + digits.drop(point)
            point in NASTRAN_POINTS -> "." + "0".repeat(-point) + digits
            else -> null
        }
        val exponent = point - 1
        val scientific = digits.take(1) + "." + digits.drop(1) + (if (exponent < 0) "" else "+") + exponent
        return if (plain != null && plain.length <= scientific.length) plain else scientific
    }

    private companion object {
        const val MOST_DIGITS = 17
        const val LOWEST_POINT = -4
        const val HIGHEST_POINT = 17
        val NASTRAN_POINTS = -4..15
    }
}
