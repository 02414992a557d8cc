package org.trigrid.shape

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2
import java.util.Random

class IntervalsTest {
    @Test
    fun `linear intervals are the arithmetic progression of the paper`() {
        // n = 4, r = 4: lengths 1, 2, 3, 4 tenths.
        assertArrayEquals(doubleArrayOf(0.0, 0.1, 0.3, 0.6, 1.0), Intervals.fractions(4, 4.0, Distribution.LINEAR), 1e-15)
    }

    @Test
    fun `geometric intervals are a geometric progression`() {
        // n = 4, r = 8: lengths 1, 2, 4, 8 fifteenths.
        val expected = doubleArrayOf(0.0, 1.0 / 15, 3.0 / 15, 7.0 / 15, 1.0)
        assertArrayEquals(expected, Intervals.fractions(4, 8.0, Distribution.GEOMETRIC), 1e-15)
    }

    @Test
    fun `symmetric intervals are alike from both ends`() {
        // n = 5, middle / ends = 3: lengths 1, 2, 3, 2, 1 ninths.
        val expected = doubleArrayOf(0.0, 1.0 / 9, 3.0 / 9, 6.0 / 9, 8.0 / 9, 1.0)
        assertArrayEquals(expected, Intervals.fractions(5, 3.0, Distribution.SYMMETRIC), 1e-15)
    }

    @Test
    fun `intervals increase, and last over first is the ratio`() {
        val random = Random(1)
        repeat(2000) {
            val count = 2 + random.nextInt(400)
            val ratio = StrictMath.exp(random.nextDouble() * 7)
            for (distribution in Distribution.entries) {
                val t = Intervals.fractions(count, ratio, distribution)
                for (k in 1..count) assertTrue(t[k] > t[k - 1])
                val first = t[1] - t[0]
                val wide = if (distribution == Distribution.SYMMETRIC) (count - 1) / 2 else count - 1
                if (count > 2) assertEquals(ratio, (t[wide + 1] - t[wide]) / first, 1e-12 * count * ratio * ratio)
            }
        }
    }

    @Test
    fun `the count is the nearest whole number and at least one`() {
        val line = Line(0.0, 0.0, 1.0, 0.0, 0.1)
        // 1 / 0.1 in floats truncates to 9 or 10 depending on the type; 0.3 / 0.1 is 2.9999999999999996.
        assertEquals(10 + 1, line.explode().size / 2)
        assertEquals(3 + 1, Line(0.0, 0.0, 0.3, 0.0, 0.1).explode().size / 2)
        assertEquals(2 + 1, line.explode(0.41, 1.0).size / 2)
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 1.0, 0.0), line.explode(5.0, 3.0))
    }

    @Test
    fun `rounded up, no interval is longer than the spacing`() {
        assertEquals(3 + 1, Line(0.0, 0.0, 0.3, 0.0, 0.1).withRounding(Rounding.CEILING).explode().size / 2)
        val random = Random(2)
        repeat(300) {
            val spacing = 0.003 + random.nextDouble()
            val ratio = StrictMath.exp(random.nextGaussian() * 2)
            for (distribution in Distribution.entries) {
                val xy = Line.explode(
                    Point2(0.0, 0.0), Point2(1.0, 0.0), spacing, ratio, distribution, Rounding.CEILING,
                )
                val longest = (1 until xy.size / 2).maxOf { xy[2 * it] - xy[2 * it - 2] }
                assertTrue(longest <= spacing * (1 + 1e-11), "$longest > $spacing, ratio $ratio, $distribution")
            }
        }
    }

    @Test
    fun `bad fields are refused by name`() {
        val line = Line(0.0, 0.0, 1.0, 0.0, 0.1)
        for (bad in doubleArrayOf(0.0, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            refused("spacing") { line.withSpacing(bad) }
            refused("ratio") { line.withRatio(bad) }
            refused("ratio") { line.explode(0.1, bad) }
            refused("spacing") { Circle.explode(Point2(1.0, 0.0), Point2(0.0, 0.0), Direction.CLOCKWISE, bad, 1.0) }
        }
        refused("spacing") { line.explode(1e-12, 1.0) }
        refused("begin") { Line(Double.NaN, 0.0, 1.0, 0.0, 0.1) }
        refused("same place") { Line(1.0, 0.0, 1.0, 0.0, 0.1) }
        refused("name") { line.withName("a\"b") }
        refused("two nodes at") { Line(1e6, 0.0, 1e6 + 1, 0.0, 0.01).withRatio(1e12).explode() }
    }

    private fun refused(field: String, action: () -> Unit) {
        val message = assertThrows(InvalidShapeException::class.java) { action() }.message!!
        assertTrue(field in message, message)
    }
}
