package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.Point2
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Circle
import org.trigrid.shape.Line
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Shape
import java.util.Random

class PathConnectTest {
    private val outer = Rectangle(0.0, 0.0, 10.0, 8.0, 1.0)
    private val bore = Circle(Point2(5.0, 4.0), Point2(4.0, 4.0), 0.5)
    private val apart = Path.of(outer).newLoop().append(bore)

    @Test
    fun `a connector in the middle of a walk is travelled there and back`() {
        val from = apart.nodesOf(0).first { apart.node(it) == Point2(4.0, 0.0) }
        val to = apart.nodesOf(1).first()
        val joined = apart.connect(from, to, 1.0)
        assertEquals(1, joined.walks().size)
        assertTrue(joined.isConnector(2))
        val line = joined.shape(2) as Line
        assertEquals(apart.node(from), line.firstPoint)
        assertEquals(apart.node(to), line.lastPoint)
        val inner = line.explode().size / 2 - 2
        assertEquals(apart.nodeCount + inner, joined.nodeCount)
        assertEquals(2 * (inner + 1), (0 until joined.walks()[0].stepCount).count { joined.walks()[0].shape(it) == 2 })
        assertSameDomain(apart, joined)
    }

    @Test
    fun `what was left out stays left out, whatever the directions`() {
        for (first in turned(outer)) {
            for (second in turned(bore)) {
                val path = Path.of(first).newLoop().append(second)
                assertSameDomain(path, path.connect(3, path.nodesOf(1)[2], 0.7))
                assertSameDomain(path, path.connect(path.nodesOf(1)[2], 3, 0.7))
            }
        }
    }

    @Test
    fun `without the connector the walks are apart again`() {
        val joined = apart.connect(3, apart.nodesOf(1)[5], 0.7)
        val again = joined.removeShape(2)
        assertEquals(apart.nodes(), again.nodes())
        assertEquals(2, again.walks().size)
        assertEquals(1, joined.removeShape(1).walks().size)
        assertEquals(1, joined.removeShape(1).shapeCount)
    }

    @Test
    fun `it stays at its nodes when they move and its shapes change`() {
        val joined = apart.connect(4, apart.nodesOf(1)[0], 0.7)
        val finer = joined.replaceShape(1, bore.withSpacing(0.1))
        assertEquals(1, finer.walks().size)
        assertEquals(Point2(5.0, 4.0), finer.shape(2).lastPoint)
        val shifted = joined.replaceShape(1, bore.withCentre(Point2(6.0, 5.0)))
        assertEquals(shifted.shape(1).firstPoint, shifted.shape(2).lastPoint)
        val wider = joined.replaceShape(2, joined.shape(2).withSpacing(10.0))
        assertEquals(2, wider.nodesOf(2).size)
        assertEquals(joined.shape(2).firstPoint, wider.shape(2).firstPoint)
        assertThrows(IllegalArgumentException::class.java) { joined.replaceShape(2, bore) }
        val moved = apart.moveNode(4, 4.0, -1.0).connect(4, apart.nodesOf(1)[0], 0.7)
        assertEquals(Point2(4.0, -1.0), moved.shape(2).firstPoint)
    }

    @Test
    fun `shapes are appended after it and edits are kept`() {
        val joined = apart.connect(4, apart.nodesOf(1)[0], 0.7)
        val more = joined.append(Circle(Point2(8.0, 4.0), Point2(7.0, 4.0), 0.5)).moveNode(2, 2.0, -0.5)
        assertEquals(2, more.walks().size)
        assertEquals(80.0 + 0.5, more.toDomain().area + 2 * area(bore), 1e-9)
        val removed = more.removeShape(1)
        assertEquals(Point2(2.0, -0.5), removed.node(2))
        assertEquals(2, removed.shapeCount)
    }

    @Test
    fun `nodes of one walk, or of an open one, are refused`() {
        assertThrows(IllegalArgumentException::class.java) { apart.connect(0, 5, 1.0) }
        val open = Path.of(outer).newLoop().append(Line(2.0, 2.0, 3.0, 3.0, 1.0))
        assertThrows(IllegalArgumentException::class.java) { open.connect(0, open.nodesOf(1)[0], 1.0) }
    }

    @Test
    fun `the shortest line that meets nothing is taken`() {
        val project = Project.of(Path.of(outer).newLoop().append(Circle(Point2(5.0, 3.0), Point2(4.0, 3.0), 0.5)))
        assertArrayEquals(intArrayOf(1), project.openings())
        val line = project.connectOpening(1, 0.5).path.shape(2)
        assertEquals(Point2(4.0, 0.0), line.firstPoint)
        assertTrue(line.lastPoint.distanceTo(Point2(4.0, 2.0)) < 0.3)
        val fence = NodeLoop(doubleArrayOf(2.0, 1.0, 6.0, 1.0, 6.0, 1.2, 2.0, 1.2), "fence")
        val fenced = project.toBuilder().loops(listOf(fence)).build()
        assertTrue(fenced.connectOpening(1, 0.5).path.shape(2).firstPoint.x == 0.0)
        assertThrows(IllegalArgumentException::class.java) { project.connectOpening(0, 0.5) }
        val cage = NodeLoop(doubleArrayOf(2.0, 1.0, 6.0, 1.0, 6.0, 5.0, 2.0, 5.0), "cage")
        assertEquals(0, project.toBuilder().loops(listOf(cage)).build().openings().size)
    }

    @Test
    fun `random openings are all connected, and the file keeps it`() {
        val random = Random(5)
        repeat(25) {
            var path = Path.of(Rectangle(0.0, 0.0, 12.0, 12.0, 0.5 + random.nextDouble()))
            for (i in 0 until 9) {
                val centre = Point2(2.0 + 4 * (i % 3) + random.nextDouble(), 2.0 + 4 * (i / 3) + random.nextDouble())
                val hole = Circle(Point2(centre.x + 0.4 + random.nextDouble() / 2, centre.y), centre, 0.3)
                path = path.newLoop().append(turned(hole)[random.nextInt(2)])
            }
            var project = Project.of(path)
            while (project.openings().isNotEmpty()) project = project.connectOpening(project.openings().last(), 0.4)
            assertEquals(1, project.path.walks().size)
            assertSameDomain(path, project.path)
            assertTrue(DomainCheck.check(project.toDomain()).isEmpty())
            val text = ProjectFile.format(project)
            val again = ProjectFile.parse(text, "again")
            assertEquals(text, ProjectFile.format(again))
            assertEquals(project.path.nodes(), again.path.nodes())
        }
    }

    private fun area(shape: Shape) = Path.of(shape).toDomain().area

    private fun turned(shape: Shape): List<Shape> = when (shape) {
        is Rectangle -> listOf(shape, shape.withDirection(shape.direction.opposite()))
        is Circle -> listOf(shape, shape.withDirection(shape.direction.opposite()))
        else -> listOf(shape)
    }

    private fun assertSameDomain(expected: Path, actual: Path) {
        val a = expected.toDomain()
        val b = actual.toDomain()
        assertEquals(a.area, b.area, 1e-9 * a.area)
        assertEquals(a.loopCount, b.loopCount)
        assertEquals(a.segmentCount, b.segmentCount)
        assertFalse(a.nodeCount != b.nodeCount)
    }
}
