package org.trigrid.shape

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2
import java.util.Random

class CurveTest {
    @Test
    fun `a curve through two vertices is a line`() {
        val xy = Curve.of(0.5, 0.0, 0.0, 3.0, 4.0).explode()
        assertArrayEquals(Line(0.0, 0.0, 3.0, 4.0, 0.5).explode(), xy, 1e-14)
    }

    @Test
    fun `the spline runs through its vertices with continuous slope and curvature`() {
        val random = Random(7)
        repeat(50) {
            val vertices = List(4 + random.nextInt(20)) { Point2(random.nextGaussian(), random.nextGaussian()) }
            for (curve in listOf(Curve(vertices, 1.0), Curve(vertices, 1.0).closed())) {
                val spline = Spline.through(curve)
                for (i in 1 until spline.knots.size - 1) {
                    val u = spline.knots[i]
                    assertEquals(spline.points[i].x, spline.x(u), 1e-12)
                    val e = 1e-4
                    // Third differences across the knot stay of the order of e: no jump in value, slope or curvature.
                    val second = (spline.x(u + e) - 2 * spline.x(u) + spline.x(u - e)) / (e * e)
                    val before = (spline.x(u) - 2 * spline.x(u - e) + spline.x(u - 2 * e)) / (e * e)
                    assertEquals(before, second, 0.05 * (1 + Math.abs(before)))
                }
            }
        }
    }

    @Test
    fun `a closed curve round a circle's points is nearly the circle`() {
        val vertices = List(12) { Point2(Turn.cos(it / 12.0), Turn.sin(it / 12.0)) }
        val xy = Curve(vertices, 0.01).closed().explode()
        assertEquals(628 + 1, xy.size / 2)
        for (i in xy.indices step 2) assertEquals(1.0, Math.hypot(xy[i], xy[i + 1]), 2e-3)
        // The natural curve ends straight, the closed one does not.
        val first = Math.atan2(xy[3], xy[2] - 1)
        assertEquals(Math.PI / 2, first, 0.02)
    }

    @Test
    fun `clamped ends leave and arrive in their directions`() {
        val curve = Curve.of(0.001, 0.0, 0.0, 1.0, 0.0, 2.0, 1.0).clamped(Point2(0.0, 5.0), Point2(-1.0, 0.0))
        val xy = curve.explode()
        assertEquals(90.0, Math.toDegrees(Math.atan2(xy[3] - xy[1], xy[2] - xy[0])), 0.5)
        val n = xy.size
        assertEquals(180.0, Math.abs(Math.toDegrees(Math.atan2(xy[n - 1] - xy[n - 3], xy[n - 2] - xy[n - 4]))), 0.5)
    }

    @Test
    fun `intervals are even along the curve whatever the spacing of its vertices`() {
        val vertices = listOf(Point2(0.0, 0.0), Point2(0.01, 0.02), Point2(0.5, 0.6), Point2(4.0, 0.0), Point2(4.01, -0.3))
        val xy = Curve(vertices, 0.002).explode()
        val lengths = (1 until xy.size / 2).map { Math.hypot(xy[2 * it] - xy[2 * it - 2], xy[2 * it + 1] - xy[2 * it - 1]) }
        // Chords of a tight bend are a little shorter than its arcs.
        assertEquals(1.0, lengths.max() / lengths.min(), 0.02)
    }

    @Test
    fun `vertices that cannot make a curve are refused`() {
        val message = assertThrows(InvalidShapeException::class.java) {
            Curve.of(0.1, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0)
        }.message!!
        assertTrue("vertices 1 and 2" in message, message)
        assertThrows(InvalidShapeException::class.java) { Curve.of(0.1, 0.0, 0.0, 1.0, 0.0).closed() }
        assertThrows(InvalidShapeException::class.java) { Curve.of(0.1, 0.0, 0.0, 1.0) }
    }
}
