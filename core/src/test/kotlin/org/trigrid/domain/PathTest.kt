package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.geometry.Point2
import org.trigrid.shape.Circle
import org.trigrid.shape.Direction
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle

class PathTest {
    private val square = Lines.of(0.5, 0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0, 0.0, 0.0).withName("square")
    private val connector = Line(0.0, 0.0, 0.5, 0.5, 0.4).withName("link")
    private val diamond = Polygon.of(9.0, 0.5, 0.5, 1.0, 0.5, 1.0, 1.0, 0.5, 1.0).withName("hole")

    @Test
    fun `shapes share the node where one ends and the next begins`() {
        val path = Path.of(Line(0.0, 0.0, 1.0, 0.0, 0.5), Line(1.0, 0.0, 0.0, 1.0, 9.0), Line(0.0, 1.0, 0.0, 0.0, 0.5))
        assertEquals(5, path.nodeCount)
        assertEquals(1, path.walks().size)
        assertTrue(path.walks()[0].isClosed)
        assertArrayEquals(intArrayOf(0, 1, 2, 3, 4), path.walks()[0].nodes())
        assertArrayEquals(intArrayOf(2, 3), path.nodesOf(1))
        assertEquals(0.5, path.toDomain().area)
    }

    @Test
    fun `ends that miss each other by rounding are one node`() {
        val path = Path.of(
            Line(0.0, 0.0, 1.0, 0.0, 0.5), Line(1.0 + 1e-15, 1e-16, 0.0, 1.0, 9.0), Line(-1e-16, 1.0, 1e-17, 0.0, 0.5),
        )
        assertEquals(5, path.nodeCount)
        assertEquals(Point2(1.0, 0.0), path.node(2))
        assertTrue(path.walks()[0].isClosed)
    }

    @Test
    fun `a gap in an open walk is bridged by a straight step`() {
        val path = Path.of(Line(0.0, 0.0, 1.0, 0.0, 1.0), Line(1.0, 1.0, 0.0, 1.0, 1.0).withName("top")).close(1.0)
        assertArrayEquals(intArrayOf(0, 1, 2, 3), path.walks()[0].nodes())
        assertEquals(-1, path.walks()[0].shape(1))
        assertEquals("top", path.walks()[0].tag(1))
        assertEquals(1.0, path.toDomain().area)
    }

    @Test
    fun `a connector is passed twice, and its nodes are made once`() {
        val path = Path.of(square).appendOpening(connector, diamond.withDirection(Direction.CLOCKWISE))
        // 16 on the square, 2 more on the connector, 3 more on the diamond.
        assertEquals(16 + 2 + 3, path.nodeCount)
        assertEquals(1, path.walks().size)
        val walk = path.walks()[0]
        assertArrayEquals(intArrayOf(0, 16, 17, 18, 19, 20, 17, 16), walk.nodes().drop(16).toIntArray())
        assertEquals("link", walk.tag(16))
        assertEquals("hole", walk.tag(18))
        assertEquals("link", walk.tag(23))
        val domain = path.toDomain()
        assertEquals(2, domain.loopCount)
        assertEquals(4 - 0.25, domain.area)
        assertEquals(20, domain.segmentCount)
        assertEquals(22, path.toDomain(true).segmentCount)
        assertEquals(listOf("square", "link", "hole"), domain.tags)
    }

    @Test
    fun `direction says what is left out, and the outer walk may run clockwise`() {
        val out = Line(0.0, 0.0, 0.0, -1.0, 0.5)
        for (outer in listOf(square, square.reversed())) {
            val isAnticlockwise = outer == square
            val left = if (isAnticlockwise) Direction.CLOCKWISE else Direction.ANTICLOCKWISE
            val path = Path.of(outer).appendOpening(connector, diamond.withDirection(left))
            assertEquals(3.75, path.toDomain().area)
            val withCircle = path.appendConnector(out).append(Line(0.0, -1.0, 3.0, 0.0, 0.5))
            assertThrows(InvalidDomainException::class.java) { withCircle.toDomain() }
            val included = path.appendOpening(Line(0.0, 0.0, -1.0, -1.0, 0.5), circleAt(-1.0, -1.0, left.opposite()))
            assertEquals(3.75 + 2.828, included.toDomain().area, 0.01)
            assertEquals(3, included.toDomain().loopCount)
        }
    }

    private fun circleAt(x: Double, y: Double, direction: Direction) =
        Circle(Point2(x, y), Point2(x - 1, y), Math.PI / 4).withDirection(direction)

    @Test
    fun `connectors chain from opening to opening`() {
        val path = Path.of(square).appendConnector(connector).append(diamond.withDirection(Direction.CLOCKWISE))
            .appendOpening(Line(0.5, 0.5, 0.25, 1.0, 1.0), Polygon.of(9.0, 0.25, 1.0, 0.2, 1.5, 0.4, 1.5))
            .back()
        assertEquals(4 - 0.25 - 0.05, path.toDomain().area, 1e-15)
        assertEquals(3, path.toDomain().loopCount)
        assertThrows(IllegalStateException::class.java) { path.back() }
    }

    @Test
    fun `loops of their own may run in any direction and be nested`() {
        for (direction in Direction.entries) {
            val path = Path.of(
                Rectangle(0.0, 0.0, 4.0, 4.0, 1.0),
                Rectangle(1.0, 1.0, 3.0, 3.0, 1.0).withDirection(direction),
                Rectangle(1.5, 1.5, 2.0, 2.0, 1.0).withDirection(direction.opposite()),
            ).newLoop().append(Rectangle(5.0, 0.0, 6.0, 1.0, 1.0).withDirection(direction))
            assertEquals(4, path.walks().size)
            val domain = path.toDomain()
            assertEquals(16 - 4 + 0.25 + 1, domain.area)
            assertEquals(1, (0 until domain.loopCount).count { domain.isHole(it) })
        }
    }

    @Test
    fun `a shape that is closed but begins elsewhere starts a loop, one that begins at the end goes on`() {
        val rectangle = Rectangle(0.0, 0.0, 4.0, 4.0, 1.0)
        assertEquals(2, Path.of(rectangle, Rectangle(1.0, 1.0, 2.0, 2.0, 1.0)).walks().size)
        assertEquals(1, Path.of(rectangle, Rectangle(0.0, 0.0, -1.0, -1.0, 1.0)).walks().size)
    }

    @Test
    fun `an open walk is no domain`() {
        val path = Path.of(Line(0.0, 0.0, 1.0, 0.0, 0.5), Line(1.0, 0.0, 1.0, 1.0, 0.5))
        val fault = assertThrows(InvalidDomainException::class.java) { path.toDomain() }.faults.single()
        assertEquals(FaultKind.OPEN_WALK, fault.kind)
        assertArrayEquals(intArrayOf(0, 4), fault.nodes())
        assertEquals(1.0, fault.y)
        assertTrue("node 4 at (1.0, 1.0)" in fault.message, fault.message)
        assertFalse(path.walks()[0].isClosed)
    }

    @Test
    fun `every segment keeps the tag of its shape whichever way the walk is taken`() {
        val sides = listOf(
            Line(0.0, 0.0, 0.0, 1.0, 0.5).withName("left"),
            Line(0.0, 1.0, 1.0, 1.0, 0.5).withName("top"),
            Line(1.0, 1.0, 1.0, 0.0, 0.5).withName("right"),
            Line(1.0, 0.0, 0.0, 0.0, 0.5),
        )
        val domain = Path.of(*sides.toTypedArray()).toDomain()
        for (s in 0 until domain.segmentCount) {
            val x = domain.x(domain.segmentStart(s)) + domain.x(domain.segmentEnd(s))
            val y = domain.y(domain.segmentStart(s)) + domain.y(domain.segmentEnd(s))
            val side = if (x == 0.0) "left" else if (x == 2.0) "right" else if (y == 2.0) "top" else "boundary"
            assertEquals(side, domain.tags[domain.segmentTag(s)])
        }
    }
}
