package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.Point2
import org.trigrid.shape.Circle
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Rectangle
import java.util.Random

class PathEditTest {
    /** 0..3 on the bottom and up the right side, 4..7 along the top and down the left. */
    private val square = Path.of(
        Lines.of(1.0, 0.0, 0.0, 2.0, 0.0, 2.0, 2.0),
        Lines.of(1.0, 2.0, 2.0, 0.0, 2.0, 0.0, 0.0),
    )

    @Test
    fun `a shape that is only renamed keeps the edits of its nodes`() {
        val path = Path.of(Rectangle(0.0, 0.0, 4.0, 2.0, 1.0)).moveNode(1, 1.0, -0.5).deleteNode(2)
        val renamed = path.replaceShape(0, path.shape(0).withName("wall"))
        assertArrayEquals(path.nodeCoordinates(), renamed.nodeCoordinates())
        assertEquals("wall", renamed.shape(0).name)
        assertEquals(12, renamed.replaceShape(0, renamed.shape(0).withName("inlet").withSpacing(1.0 + 1e-9)).nodes().size)
    }

    @Test
    fun `a moved node takes all walks along and unlinks its shapes`() {
        val moved = square.moveNode(1, 1.0, -0.5)
        assertEquals(Point2(1.0, -0.5), moved.node(1))
        assertEquals(Point2(1.0, 0.0), square.node(1))
        assertFalse(moved.isLinked(0))
        assertTrue(moved.isLinked(1))
        assertTrue(square.isLinked(0))
        assertEquals(4.5, moved.toDomain().area)
        val corner = square.moveNode(4, 3.0, 3.0)
        assertFalse(corner.isLinked(0))
        assertFalse(corner.isLinked(1))
    }

    @Test
    fun `a walk that came off can be turned round`() {
        val bowtie = Path.of(Lines.of(9.0, 0.0, 0.0, 2.0, 2.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0))
        val split = bowtie.insertNode(0, 1, 1.0, 1.0).insertNode(3, 4, 1.0, 1.0)
        assertEquals(2, split.walks().size)
        assertEquals(1, DomainCheck.check(split.toDomain()).size)
        val own = split.walks()[1].nodes().first { it !in split.walks()[0].nodes() }
        val turned = split.turnWalk(own)
        assertTrue(DomainCheck.check(turned.toDomain()).isEmpty())
        assertEquals(2.0, turned.toDomain().area)
        assertEquals(split.walks()[1].nodes().toSet(), turned.walks()[1].nodes().toSet())
        assertTrue(turned.isLinked(0) == split.isLinked(0))
        assertThrows(IllegalArgumentException::class.java) { Path.of(Line(0.0, 0.0, 1.0, 0.0, 1.0)).turnWalk(0) }
    }

    @Test
    fun `dragging a node is one step of the history`() {
        var path = square
        for (i in 1..100) path = path.moveNode(1, 1.0, -i / 100.0)
        assertEquals(square.steps.size + 1, path.steps.size)
        assertEquals(-1.0, path.y(1))
    }

    @Test
    fun `deleting lowers later numbers and joins the neighbours`() {
        val path = square.deleteNode(2)
        assertEquals(7, path.nodeCount)
        assertArrayEquals(IntArray(7) { it }, path.walks()[0].nodes())
        assertEquals(Point2(2.0, 1.0), path.node(2))
        assertEquals(3.5, path.toDomain().area)
        val withoutStart = square.deleteNode(0)
        assertTrue(withoutStart.walks()[0].isClosed)
        assertEquals(3.5, withoutStart.toDomain().area)
    }

    @Test
    fun `an inserted node gets the number after its neighbour`() {
        val path = square.insertNode(2, 3, 3.0, 0.5)
        assertEquals(Point2(3.0, 0.5), path.node(3))
        assertEquals(9, path.nodeCount)
        assertEquals(4.5, path.toDomain().area)
        assertArrayEquals(IntArray(9) { it }, path.walks()[0].nodes())
        assertEquals(Point2(-1.0, 0.5), square.insertNode(7, 0, -1.0, 0.5).node(8))
        assertThrows(IllegalArgumentException::class.java) { square.insertNode(2, 5, 0.0, 0.0) }
        assertThrows(IllegalArgumentException::class.java) { square.insertNode(2, 3, Double.NaN, 0.0) }
        assertThrows(IndexOutOfBoundsException::class.java) { square.deleteNode(8) }
    }

    @Test
    fun `of two nodes at one place the higher number goes`() {
        for ((moved, onto) in listOf(2 to 3, 3 to 2)) {
            val target = square.node(onto)
            val path = square.moveNode(moved, target.x, target.y)
            assertEquals(7, path.nodeCount)
            assertEquals(target, path.node(2))
            assertArrayEquals(IntArray(7) { it }, path.walks()[0].nodes())
        }
        val closes = Path.of(Lines.of(1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.5, 0.5)).moveNode(3, 0.0, 0.0)
        assertTrue(closes.walks().single().isClosed)
        assertEquals(3, closes.nodeCount)
    }

    @Test
    fun `a part comes off when one node of its neck is moved onto the other`() {
        val apart = Path.of(
            Lines.of(1.0, 0.0, 0.0, 4.0, 0.0, 4.0, 1.0),
            Lines.of(9.0, 4.0, 1.0, 5.0, 0.0, 6.0, 1.0, 5.0, 2.0, 4.0, 1.5),
            Lines.of(1.0, 4.0, 1.5, 4.0, 4.0, 0.0, 4.0, 0.0, 0.0),
        )
        val lower = apart.nodesOf(1).first()
        val upper = apart.nodesOf(1).last()
        assertEquals(1, apart.walks().size)
        val off = apart.moveNode(upper, apart.x(lower), apart.y(lower))
        assertEquals(apart.nodeCount - 1, off.nodeCount)
        assertEquals(2, off.walks().size)
        assertTrue(off.walks().all { it.isClosed })
        assertTrue(off.walks().all { lower in it.nodes() })
        assertEquals(16.0 + 2.0, off.toDomain().area)
        assertEquals(2, off.toDomain().loopCount)
    }

    @Test
    fun `a connector's nodes are edited both ways`() {
        val outer = Rectangle(0.0, 0.0, 4.0, 4.0, 1.0)
        val link = Line(0.0, 0.0, 1.0, 1.0, 0.5)
        val hole = Circle(Point2(1.0, 1.0), Point2(2.0, 1.0), 0.8)
        val path = Path.of(outer).appendOpening(link, hole)
        val onLink = path.nodesOf(1)[1]
        val moved = path.moveNode(onLink, 0.6, 0.4).insertNode(onLink, 0, 0.2, 0.1)
        val walk = moved.walks().single()
        assertEquals(2, walk.nodes().count { it == onLink })
        assertEquals(2, walk.nodes().count { it == onLink + 1 })
        assertEquals(path.toDomain(false).segmentCount, moved.toDomain(false).segmentCount)
        assertEquals(path.toDomain(true).segmentCount + 1, moved.toDomain(true).segmentCount)
    }

    @Test
    fun `an edit between a connector and its way back is travelled back too`() {
        val begun = Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0)).appendConnector(Line(0.0, 0.0, 1.0, 1.0, 0.5))
        val onLink = begun.nodesOf(1)[1]
        val path = begun.moveNode(onLink, 0.4, 0.6).append(Circle(Point2(1.0, 1.0), Point2(2.0, 1.0), 0.8)).back()
        assertEquals(2, path.walks().single().nodes().count { it == onLink })
        assertEquals(path.toDomain(true).segmentCount, path.toDomain(false).segmentCount + 3)
    }

    @Test
    fun `rebuilding returns to the shape and keeps other edits`() {
        val path = square.moveNode(1, 1.0, -0.5).insertNode(1, 2, 1.5, -0.7).deleteNode(3).moveNode(5, 1.0, 3.0)
        assertFalse(path.isLinked(0))
        val rebuilt = path.rebuild(0)
        assertTrue(rebuilt.isLinked(0))
        assertFalse(rebuilt.isLinked(1))
        assertEquals(8, rebuilt.nodeCount)
        assertEquals(Point2(1.0, 3.0), rebuilt.node(5))
        val all = rebuilt.rebuild(1)
        assertArrayEquals(square.nodeCoordinates(), all.nodeCoordinates())
        assertEquals(square.steps.size, all.steps.size)
    }

    @Test
    fun `a replaced shape is exploded anew and edits elsewhere stay`() {
        val path = square.moveNode(1, 1.0, -0.5).moveNode(5, 1.0, 3.0).replaceShape(0, square.shape(0).withSpacing(0.5))
        assertEquals(9 + 3, path.nodeCount)
        assertEquals(Point2(0.5, 0.0), path.node(1))
        assertEquals(Point2(1.0, 3.0), path.node(9))
        assertTrue(path.isLinked(0))
    }

    @Test
    fun `a removed connector takes its way back along`() {
        val path = Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0))
            .appendOpening(Line(0.0, 0.0, 1.0, 1.0, 0.5), Circle(Point2(1.0, 1.0), Point2(2.0, 1.0), 0.8))
        val moved = path.moveNode(path.nodesOf(2)[2], 2.0, 2.2)
        val removed = moved.removeShape(1)
        assertEquals(2, removed.shapeCount)
        assertEquals(2, removed.walks().size)
        assertTrue(removed.walks().all { it.isClosed })
        assertTrue(removed.nodes().contains(Point2(2.0, 2.2)))
        assertEquals(1, moved.removeShape(2).removeShape(1).walks().size)
    }

    @Test
    fun `random edits keep walks and numbers together`() {
        val random = Random(8)
        repeat(200) {
            var path = Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0))
                .appendOpening(Line(0.0, 0.0, 1.0, 1.0, 0.5), Circle(Point2(1.0, 1.0), Point2(2.0, 1.0), 0.8))
                .newLoop().append(Rectangle(5.0, 0.0, 7.0, 3.0, 1.0))
            repeat(20) {
                val node = random.nextInt(path.nodeCount)
                val walk = path.walks()[random.nextInt(path.walks().size)].nodes()
                val step = random.nextInt(walk.size)
                val target = path.node(random.nextInt(path.nodeCount))
                path = when (random.nextInt(4)) {
                    0 -> path.moveNode(node, random.nextGaussian(), random.nextGaussian())
                    1 -> path.moveNode(node, target.x, target.y)
                    2 -> if (path.nodeCount > 4) path.deleteNode(node) else path
                    else -> if (walk.size > 1 && step + 1 < walk.size) {
                        path.insertNode(walk[step], walk[step + 1], random.nextGaussian(), random.nextGaussian())
                    } else {
                        path
                    }
                }
                check(path)
            }
            val rebuilt = (0 until path.shapeCount).fold(path) { p, shape -> p.rebuild(shape) }
            assertTrue((0 until rebuilt.shapeCount).all { rebuilt.isLinked(it) })
        }
    }

    private fun check(path: Path) {
        val places = path.nodes().toSet()
        assertEquals(path.nodeCount, places.size)
        assertTrue(path.undoneSteps().isEmpty())
        for (walk in path.walks()) {
            val nodes = walk.nodes()
            assertTrue(nodes.all { it in 0 until path.nodeCount })
            for (i in 1 until nodes.size) assertTrue(nodes[i] != nodes[i - 1])
            assertEquals(if (walk.isClosed) nodes.size else nodes.size - 1, walk.stepCount)
        }
        val used = path.walks().flatMap { it.nodes().toList() }.toSet()
        assertEquals((0 until path.nodeCount).toSet(), used)
    }
}
