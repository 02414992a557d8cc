package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.io.ByteArrayOutputStream
import java.math.BigDecimal
import java.math.MathContext
import java.util.Random

class ShortestDecimalTest {
    private fun written(value: Double): String {
        val out = ByteArrayOutputStream()
        TextBuffer(out).apply { number(value) }.flush()
        return out.toString(Charsets.US_ASCII)
    }

    @Test
    fun `forms by hand`() {
        val cases = mapOf(
            0.0 to "0", -0.0 to "0", 1.0 to "1", -2.5 to "-2.5", 0.1 to "0.1", 0.3 to "0.3", 0.1 + 0.2 to "0.30000000000000004",
            100.0 to "100", 123456.789 to "123456.789", 0.0001 to "0.0001", 0.00001 to "0.00001", 1e-6 to "1e-6",
            1e16 to "10000000000000000", 1.5e300 to "1.5e300", 1e23 to "1e23", 5e-324 to "5e-324",
            Double.MAX_VALUE to "1.7976931348623157e308", java.lang.Double.MIN_NORMAL to "2.2250738585072014e-308",
            2e-323 to "2e-323", 9007199254740993e0 to "9007199254740992", 1.0 / 3 to "0.3333333333333333", 12e17 to "1.2e18",
        )
        for ((value, text) in cases) assertEquals(text, written(value))
    }

    @Test
    fun `every number reads back, and no shorter one does`() {
        val random = Random(20)
        repeat(4_000) { i ->
            val value = some(random, i)
            check(value)
            check(Math.nextUp(value))
            check(Math.nextDown(value))
        }
    }

    @Test
    fun `numbers read back`() {
        val random = Random(21)
        repeat(60_000) { i -> assertReadsBack(some(random, i)) }
    }

    @Test
    @Tag("corpus")
    fun `millions of numbers read back`() {
        val random = Random(22)
        repeat(5_000_000) { i -> assertReadsBack(some(random, i)) }
    }

    private fun assertReadsBack(value: Double) {
        if (!value.isFinite()) return
        assertEquals(value, written(value).toDouble())
    }

    /** Of all sizes, of the usual size, with few decimals, and powers of two. */
    private fun some(random: Random, i: Int): Double = when (i % 4) {
        0 -> Double.fromBits(random.nextLong() and Long.MAX_VALUE)
        1 -> random.nextDouble()
        2 -> random.nextInt(1_000_000) / 1000.0
        else -> Math.scalb(1.0, random.nextInt(2098) - 1074)
    }

    private fun check(value: Double) {
        if (!value.isFinite() || value == 0.0) return
        val text = written(value)
        assertEquals(value, text.toDouble(), text)
        val decimal = BigDecimal(text).stripTrailingZeros()
        if (decimal.precision() == 1) return
        // The nearest decimals with one digit less, on both sides.
        val exact = BigDecimal(value)
        for (mode in listOf(java.math.RoundingMode.DOWN, java.math.RoundingMode.UP)) {
            val shorter = exact.round(MathContext(decimal.precision() - 1, mode))
            assertTrue(shorter.toDouble() != value, "$text could be $shorter")
        }
        // Nearest of its length.
        val nearest = exact.round(MathContext(decimal.precision(), java.math.RoundingMode.HALF_EVEN))
        if (nearest.toDouble() == value) {
            assertTrue(exact.subtract(decimal).abs() <= exact.subtract(nearest).abs(), "$text is not the nearest, $nearest is")
        }
    }

    @Test
    fun `whole numbers`() {
        val out = ByteArrayOutputStream()
        val text = TextBuffer(out)
        val numbers = listOf(0L, 7L, 10L, 99L, 100L, -1L, 1234567890123456789L, Long.MAX_VALUE, Long.MIN_VALUE)
        for (n in numbers) text.number(n).line()
        text.flush()
        assertEquals(numbers.joinToString("\n", postfix = "\n"), out.toString(Charsets.US_ASCII))
    }
}
