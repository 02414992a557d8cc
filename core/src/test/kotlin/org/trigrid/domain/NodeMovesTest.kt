package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.geometry.Point2
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Circle
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Similarity
import java.util.Random

class NodeMovesTest {
    private val square = Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0))

    @Test
    fun `many nodes move at once, and again in one step`() {
        val nodes = intArrayOf(1, 2, 3)
        var path = square
        for (i in 1..50) path = path.moveNodes(nodes, doubleArrayOf(1.0, -0.01 * i, 2.0, -0.01 * i, 3.0, -0.01 * i))
        assertEquals(listOf(Point2(1.0, -0.5), Point2(2.0, -0.5), Point2(3.0, -0.5)), nodes.map { path.node(it) })
        assertEquals(square.steps.size + 3, path.steps.size)
        assertEquals(square.nodeCount, path.nodeCount)
    }

    @Test
    fun `nodes may change places`() {
        val all = IntArray(square.nodeCount) { it }
        for (degrees in listOf(90.0, 180.0, 270.0)) {
            val turn = Similarity.rotation(Point2(2.0, 2.0), degrees)
            val places = square.nodes().map { turn.apply(it) }
            val path = square.moveNodes(all, flat(places))
            assertEquals(places, path.nodes())
            assertEquals(16.0, path.toDomain().area)
            val again = ProjectFile.parse(ProjectFile.format(Project.of(path)), "again").path
            assertEquals(places, again.nodes())
            assertEquals(square.nodes(), path.moveNodes(all, flat(square.nodes())).nodes())
        }
    }

    @Test
    fun `one that comes to lie on another merges with it`() {
        val onto = square.moveNodes(intArrayOf(1, 2), doubleArrayOf(1.0, 0.5, 3.0, 0.0))
        assertEquals(square.nodeCount - 1, onto.nodeCount)
        val together = square.moveNodes(intArrayOf(1, 3), doubleArrayOf(1.5, -1.0, 1.5, -1.0))
        assertEquals(square.nodeCount - 1, together.nodeCount)
        val next = square.moveNodes(intArrayOf(1, 2), doubleArrayOf(2.0, 0.0, 3.0, 0.0))
        assertEquals(square.nodeCount - 1, next.nodeCount)
        assertEquals(Point2(2.0, 0.0), next.node(1))
    }

    @Test
    fun `a shape changed later drops the moves of its own nodes only`() {
        val path = square.newLoop().append(Circle(2.0, 2.0, 1.0, 0.5))
        val other = path.nodesOf(1)[2]
        val moved = path.moveNodes(intArrayOf(1, other), doubleArrayOf(1.0, -0.5, 2.0, 2.0))
        val changed = moved.replaceShape(0, Rectangle(0.0, 0.0, 4.0, 4.0, 0.5))
        assertTrue(changed.isLinked(0))
        assertEquals(Point2(2.0, 2.0), changed.node(changed.nodesOf(1)[2]))
    }

    @Test
    fun `single moves and one of all end alike where nothing meets`() {
        val random = Random(3)
        repeat(50) {
            val nodes = (0 until square.nodeCount).shuffled(random).take(6).toIntArray()
            val xy = DoubleArray(12) { random.nextDouble() }
            var single = square
            for ((i, node) in nodes.withIndex()) single = single.moveNode(node, xy[2 * i], xy[2 * i + 1])
            assertEquals(single.nodes(), square.moveNodes(nodes, xy).nodes())
        }
    }

    @Test
    fun `what is no place is refused`() {
        assertThrows(IllegalArgumentException::class.java) { square.moveNodes(intArrayOf(1), doubleArrayOf(0.0)) }
        assertThrows(IllegalArgumentException::class.java) { square.moveNodes(intArrayOf(1), doubleArrayOf(0.0, Double.NaN)) }
        assertThrows(IndexOutOfBoundsException::class.java) { square.moveNodes(intArrayOf(99), doubleArrayOf(0.0, 0.0)) }
        assertEquals(square, square.moveNodes(IntArray(0), DoubleArray(0)))
    }

    private fun flat(points: List<Point2>) = DoubleArray(2 * points.size) { if (it % 2 == 0) points[it / 2].x else points[it / 2].y }
}
