package org.trigrid.project

import org.trigrid.io.ShortestDecimal
import java.math.BigDecimal

/** Decimal text of doubles: as few digits as read back exactly, and the same on every Java version. */
internal object NumberText {
    private val PLAIN = -5..20

    fun of(value: Double): String {
        if (value == 0.0) return if (1 / value < 0) "-0" else "0"
        val digits = shortest(value).stripTrailingZeros()
        // Exponent of the first digit: 3 for 1234.5.
        val exponent = digits.precision() - digits.scale() - 1
        return if (exponent in PLAIN) digits.toPlainString() else scientific(digits, exponent)
    }

    private fun shortest(value: Double): BigDecimal {
        val decimal = ShortestDecimal()
        decimal.of(Math.abs(value))
        val digits = BigDecimal.valueOf(decimal.digits, -decimal.exponent)
        return if (value < 0) digits.negate() else digits
    }

    private fun scientific(digits: BigDecimal, exponent: Int): String {
        val unscaled = digits.unscaledValue().abs().toString()
        val sign = if (digits.signum() < 0) "-" else ""
        val fraction = if (unscaled.length > 1) "." + unscaled.substring(1) else ""
        return "$sign${unscaled[0]}${fraction}e$exponent"
    }
}
