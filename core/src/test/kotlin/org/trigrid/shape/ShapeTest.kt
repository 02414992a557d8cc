package org.trigrid.shape

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2
import java.util.Random

/** Each shape by known counts, ends and lengths, and all of them by what must hold whatever the parameters. */
class ShapeTest {
    @Test
    fun `the opposite direction gives the same nodes in the opposite order, bit for bit`() {
        val random = Random(3)
        repeat(60) {
            for (shape in randomShapes(random)) {
                val there = shape.explode()
                val back = shape.reversed().explode()
                TrackExploder.reverse(back)
                assertArrayEquals(there, back, shape.toString())
            }
        }
    }

    @Test
    fun `ends are exact and no two neighbours coincide`() {
        val random = Random(4)
        repeat(60) {
            for (shape in randomShapes(random)) {
                val xy = shape.explode()
                assertEquals(shape.firstPoint, Point2(xy[0], xy[1]), shape.toString())
                assertEquals(shape.lastPoint, Point2(xy[xy.size - 2], xy[xy.size - 1]), shape.toString())
                for (i in 2 until xy.size step 2) assertTrue(xy[i] != xy[i - 2] || xy[i + 1] != xy[i - 1])
                assertEquals(shape.isClosed(), shape.firstPoint == shape.lastPoint)
            }
        }
    }

    @Test
    fun `shapes scaled by a power of two explode to scaled nodes`() {
        val scale = 1024.0
        val random = Random(5)
        repeat(100) {
            val a = Point2(random.nextGaussian(), random.nextGaussian())
            val b = Point2(random.nextGaussian(), random.nextGaussian())
            fun big(p: Point2) = Point2(p.x * scale, p.y * scale)
            val small = Circle(a, b, 0.1).explode()
            val large = Circle(big(a), big(b), 0.1 * scale).explode()
            assertArrayEquals(DoubleArray(small.size) { small[it] * scale }, large)
        }
    }

    @Test
    fun `equal parameters make equal shapes`() {
        for ((a, b) in randomShapes(Random(6)).zip(randomShapes(Random(6)))) {
            assertEquals(a, b)
            assertEquals(a.hashCode(), b.hashCode())
            assertNotEquals(a, a.withSpacing(a.spacing * 2))
            assertNotEquals(a, a.withName("other"))
            assertEquals(a, a.withRatio(1.0).withRatio(a.ratio))
        }
    }

    @Test
    fun `the three ways to explode agree`() {
        val line = Line(0.0, 0.0, 3.0, 4.0, 0.5).withRatio(2.0)
        val expected = line.explode()
        assertArrayEquals(expected, line.withSpacing(9.0).withRatio(1.0).explode(0.5, 2.0))
        assertArrayEquals(expected, Line.explode(Point2(0.0, 0.0), Point2(3.0, 4.0), 0.5, 2.0))
        assertEquals(11, expected.size / 2)
    }

    @Test
    fun `every vertex of lines is a node and the ratio holds on each line`() {
        val xy = Lines.of(0.25, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0).withRatio(3.0).explode()
        assertEquals(4 + 8 + 1, xy.size / 2)
        assertEquals(Point2(1.0, 0.0), Point2(xy[8], xy[9]))
        assertEquals(3.0, (xy[8] - xy[6]) / (xy[2] - xy[0]), 1e-12)
        assertEquals(3.0, (xy[25] - xy[23]) / (xy[11] - xy[9]), 1e-12)
    }

    @Test
    fun `a rectangle goes round from whichever corner it begins, in its direction`() {
        val corners = listOf(Point2(0.0, 0.0), Point2(2.0, 0.0), Point2(2.0, 1.0), Point2(0.0, 1.0))
        for (i in 0..3) {
            for (direction in Direction.entries) {
                val rectangle = Rectangle(corners[i], corners[(i + 2) % 4], 0.25).withDirection(direction)
                val xy = rectangle.explode()
                assertEquals(24 + 1, xy.size / 2)
                assertEquals(2.0 * direction.sign, area(xy), 1e-14)
            }
        }
        assertThrows(InvalidShapeException::class.java) { Rectangle(0.0, 0.0, 0.0, 1.0, 0.1) }
    }

    @Test
    fun `a regular polygon has its vertices as nodes`() {
        val hexagon = Polygon(Point2(2.0, 0.0), Point2(0.0, 0.0), 6, 0.5)
        val xy = hexagon.explode()
        assertEquals(6 * 4 + 1, xy.size / 2)
        assertEquals(6 * Math.sqrt(3.0), area(xy), 1e-12)
        assertEquals(2.0, hexagon.radius)
        for (k in 0..5) assertEquals(2.0, Math.hypot(xy[8 * k], xy[8 * k + 1]), 1e-14)
        assertEquals(-6 * Math.sqrt(3.0), area(hexagon.withDirection(Direction.CLOCKWISE).explode()), 1e-12)
    }

    @Test
    fun `a polygon's ratio runs once round its perimeter`() {
        val square = Polygon.of(0.05, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0).withRatio(4.0)
        val xy = square.explode()
        val lengths = (1 until xy.size / 2).map { Math.hypot(xy[2 * it] - xy[2 * it - 2], xy[2 * it + 1] - xy[2 * it - 1]) }
        assertEquals(80.0, lengths.size.toDouble(), 3.0)
        assertEquals(4.0, lengths.last() / lengths.first(), 0.4)
        for (i in 1 until lengths.size) assertEquals(1.0, lengths[i] / lengths[i - 1], 0.1)
    }

    @Test
    fun `a circle's nodes are evenly turned and exact at quarters`() {
        val xy = Circle(1.0, 2.0, 2.0, Math.PI / 2).explode()
        assertEquals(8 + 1, xy.size / 2)
        assertArrayEquals(doubleArrayOf(3.0, 2.0), xy.copyOfRange(0, 2))
        assertArrayEquals(doubleArrayOf(1.0, 4.0), xy.copyOfRange(4, 6))
        assertArrayEquals(doubleArrayOf(-1.0, 2.0), xy.copyOfRange(8, 10))
        assertArrayEquals(doubleArrayOf(1.0, 0.0), xy.copyOfRange(12, 14))
        assertEquals(1 + Math.sqrt(2.0), xy[2], 1e-15)
    }

    @Test
    fun `an ellipse is cut by arc length`() {
        // Perimeter of the ellipse 2 : 1 is 9.688448220547675 (complete elliptic integral).
        val ellipse = Ellipse(0.0, 0.0, 2.0, 1.0, 9.688448220547675 / 4)
        val xy = ellipse.explode()
        assertArrayEquals(doubleArrayOf(2.0, 0.0, 0.0, 1.0, -2.0, 0.0, 0.0, -1.0, 2.0, 0.0), xy, 1e-13)
        val fine = ellipse.withSpacing(1e-3).explode()
        val lengths = (1 until fine.size / 2).map { Math.hypot(fine[2 * it] - fine[2 * it - 2], fine[2 * it + 1] - fine[2 * it - 1]) }
        assertEquals(9.688448220547675, lengths.sum(), 1e-5)
        assertEquals(1.0, lengths.max() / lengths.min(), 1e-6)
        val flat = Ellipse(0.0, 0.0, 1000.0, 1.0, 1.0).explode()
        assertEquals(1.0, (1 until 20).maxOf { Math.hypot(flat[2 * it] - flat[2 * it - 2], flat[2 * it + 1] - flat[2 * it - 1]) }, 0.01)
        assertThrows(InvalidShapeException::class.java) {
            Ellipse(Point2(2.1, 0.0), Point2(0.0, 0.0), 2.0, 1.0, 0.1)
        }
    }

    @Test
    fun `a rotated ellipse keeps its radii`() {
        val ellipse = Ellipse(1.0, 1.0, 3.0, 1.0, 0.2).withRotationDegrees(90.0)
        assertEquals(Point2(1.0, 4.0), ellipse.firstPoint)
        val xy = ellipse.explode()
        assertEquals(2.0, (0 until xy.size step 2).maxOf { xy[it] }, 1e-2)
        assertEquals(Math.PI * 3, area(xy), 0.1)
    }

    @Test
    fun `an arc turns by its angle`() {
        val half = Arc(Point2(1.0, 0.0), Point2(-1.0, 0.0), 180.0, Math.PI / 4)
        val root = Math.sqrt(0.5)
        assertArrayEquals(doubleArrayOf(1.0, 0.0, root, root, 0.0, 1.0, -root, root, -1.0, 0.0), half.explode(), 1e-15)
        assertEquals(1.0, half.radius, 1e-15)
        for (angle in doubleArrayOf(1e-9, 10.0, 90.0, 180.0, 300.0)) {
            val c = Math.cos(Math.toRadians(angle))
            val s = Math.sin(Math.toRadians(angle))
            val arc = Arc.around(Point2(0.0, 0.0), Point2(1.0, 0.0), Point2(c, s), Direction.ANTICLOCKWISE, 0.1)
            assertEquals(angle, arc.angleDegrees, 1e-12 * 360)
            if (angle < 1) continue
            val middle = Math.toRadians(angle / 3)
            val through = Arc.through(Point2(1.0, 0.0), Point2(Math.cos(middle), Math.sin(middle)), Point2(c, s), 0.1)
            assertEquals(angle, through.angleDegrees, 1e-9)
            val xy = through.explode()
            for (i in xy.indices step 2) assertEquals(1.0, Math.hypot(xy[i], xy[i + 1]), 1e-12)
            assertEquals(-angle, through.reversed().angleDegrees, 1e-9)
        }
        assertThrows(InvalidShapeException::class.java) { Arc(Point2(1.0, 0.0), Point2(0.0, 0.0), 360.0, 0.1) }
    }

    private fun area(xy: DoubleArray): Double {
        var sum = 0.0
        for (i in 2 until xy.size step 2) sum += xy[i - 2] * xy[i + 1] - xy[i] * xy[i - 1]
        return sum / 2
    }
}
