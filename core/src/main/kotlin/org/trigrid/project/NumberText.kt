package org.trigrid.project

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode

/** Decimal text of doubles: few digits, read back exactly, and the same on every Java version. */
internal object NumberText {
    private val PLAIN = -5..20

    fun of(value: Double): String {
        if (value == 0.0) return if (1 / value < 0) "-0" else "0"
        val digits = shortest(value).stripTrailingZeros()
        // Exponent of the first digit: 3 for 1234.5.
        val exponent = digits.precision() - digits.scale() - 1
        return if (exponent in PLAIN) digits.toPlainString() else scientific(digits, exponent)
    }

    /** Every double is told by 17 digits, many by 15. */
    private fun shortest(value: Double): BigDecimal {
        val exact = BigDecimal(value)
        for (precision in 15..16) {
            val rounded = exact.round(MathContext(precision, RoundingMode.HALF_EVEN))
            if (rounded.toDouble() == value) return rounded
        }
        return exact.round(MathContext(17, RoundingMode.HALF_EVEN))
    }

    private fun scientific(digits: BigDecimal, exponent: Int): String {
        val unscaled = digits.unscaledValue().abs().toString()
        val sign = if (digits.signum() < 0) "-" else ""
        val fraction = if (unscaled.length > 1) "." + unscaled.substring(1) else ""
        return "$sign${unscaled[0]}${fraction}e$exponent"
    }
}
