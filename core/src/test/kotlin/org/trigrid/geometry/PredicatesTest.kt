package org.trigrid.geometry

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import java.math.BigDecimal
import java.util.Random

class PredicatesTest {
    private val random = Random(17)

    @Test
    fun `orientation of places one unit in the last place apart is exact`() {
        for (offset in listOf(0.5, 12.0, 1e7)) {
            for (i in 0..31) for (j in 0..31) {
                val x = offset + i * Math.ulp(offset)
                val y = offset + j * Math.ulp(offset)
                checkOrient(x, y, 2 * offset, 2 * offset, 4 * offset, 4 * offset)
                checkOrient(x, y, offset + 0.3, offset + 0.7, -offset, offset)
            }
        }
    }

    @Test
    fun `orientation of nearly collinear places is exact whatever the exponents`() {
        repeat(20_000) {
            val ax = number()
            val ay = number()
            val bx = number()
            val by = number()
            val t = random.nextDouble() * 3 - 1
            checkOrient(ax, ay, bx, by, ax + t * (bx - ax), ay + t * (by - ay))
        }
    }

    @Test
    fun `incircle of nearly cocircular places is exact`() {
        repeat(5_000) {
            val x = random.nextInt(3) * 1e6 * random.nextDouble()
            val p = DoubleArray(8)
            for (k in 0..3) {
                val angle = 2 * Math.PI * random.nextDouble()
                p[2 * k] = x + Math.cos(angle)
                p[2 * k + 1] = Math.sin(angle)
            }
            val sign = Predicates.inCircle(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7])
            assertEquals(exactInCircle(p), Math.signum(sign).toInt())
        }
    }

    @Test
    fun `the corners of a square lie on one circle`() {
        for (s in listOf(1.0, 0.1, 1e-9, 3e8)) assertEquals(0.0, Predicates.inCircle(0.0, 0.0, s, 0.0, s, s, 0.0, s))
    }

    private fun number(): Double = (random.nextDouble() - 0.5) * Math.scalb(1.0, random.nextInt(40) - 20)

    private fun checkOrient(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double) {
        val left = (big(ax) - big(cx)) * (big(by) - big(cy))
        val right = (big(ay) - big(cy)) * (big(bx) - big(cx))
        assertEquals(left.compareTo(right), Math.signum(Predicates.orient(ax, ay, bx, by, cx, cy)).toInt())
    }

    private fun exactInCircle(p: DoubleArray): Int {
        val rows = List(3) { k ->
            val dx = big(p[2 * k]) - big(p[6])
            val dy = big(p[2 * k + 1]) - big(p[7])
            Triple(dx, dy, dx * dx + dy * dy)
        }
        val (a, b, c) = rows
        val det = a.third * (b.first * c.second - c.first * b.second) +
            b.third * (c.first * a.second - a.first * c.second) + c.third * (a.first * b.second - b.first * a.second)
        return det.signum()
    }

    private fun big(value: Double) = BigDecimal(value)
}
