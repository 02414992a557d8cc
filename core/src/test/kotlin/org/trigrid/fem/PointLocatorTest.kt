package org.trigrid.fem

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.locationtech.jts.algorithm.Distance
import org.locationtech.jts.geom.Coordinate
import org.trigrid.geometry.Predicates
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh
import kotlin.random.Random

class PointLocatorTest {
    private val mesh = GridMeshes.shaken(12, 9, 3L) { i, j -> i in 4..6 && j in 3..5 || i == 9 && j == 1 }.mesh
    private val locator = PointLocator.of(mesh)

    @Test
    fun `random places are found where a look at every element finds them`() {
        val random = Random(7)
        var outside = 0
        repeat(3000) {
            val x = random.nextDouble(-2.0, 14.0)
            val y = random.nextDouble(-2.0, 11.0)
            val expected = (0 until mesh.elementCount).firstOrNull { holds(it, x, y) } ?: TriMesh.NONE
            if (expected < 0) outside++
            assertEquals(expected, locator.elementAt(x, y))
        }
        assertTrue(outside in 500..2500)
    }

    @Test
    fun `nodes are found in the first of their elements`() {
        val found = locator.elementsAt(mesh.nodeCoordinates())
        for (node in 0 until mesh.nodeCount) {
            val first = (0 until mesh.elementCount).first { t -> (0..2).any { mesh.nodeOf(t, it) == node } }
            assertEquals(first, found[node])
        }
    }

    @Test
    fun `what is not a number is nowhere`() {
        assertEquals(TriMesh.NONE, locator.elementAt(Double.NaN, 1.0))
        assertEquals(TriMesh.NONE, locator.elementAt(1.0, Double.POSITIVE_INFINITY))
        assertThrows<IllegalArgumentException> { locator.nearest(Double.NaN, 1.0) }
        assertThrows<IllegalArgumentException> { locator.elementsAt(DoubleArray(3)) }
        val empty = PointLocator.of(TriMesh.of(DoubleArray(0), IntArray(0)))
        assertEquals(TriMesh.NONE, empty.elementAt(0.0, 0.0))
        assertThrows<IllegalArgumentException> { empty.nearest(0.0, 0.0) }
    }

    @Test
    fun `the nearest place is as near as the nearest boundary edge, and in its element`() {
        val random = Random(8)
        repeat(2000) {
            val far = if (it % 10 == 0) 1e6 else 1.0
            val x = far * random.nextDouble(-8.0, 20.0)
            val y = far * random.nextDouble(-8.0, 17.0)
            val place = locator.nearest(x, y)
            if (locator.elementAt(x, y) >= 0) {
                assertArrayEquals(doubleArrayOf(x, y, 0.0), doubleArrayOf(place.x, place.y, place.distance))
                assertEquals(locator.elementAt(x, y), place.element)
            } else {
                val expected = (0 until mesh.boundaryEdgeCount).minOf { edge -> distance(edge, x, y) }
                assertEquals(expected, place.distance, 1e-12 * far)
                assertEquals(place.distance, Math.hypot(place.x - x, place.y - y), 1e-12 * far)
                assertTrue(LinearElements.of(mesh).weights(place.element, place.x, place.y).all { w -> w > -1e-12 })
            }
        }
        assertTrue(locator.nearest(1e308, -1e308).distance > 1e308)
    }

    private fun holds(t: Int, x: Double, y: Double) = (0..2).all {
        val a = mesh.nodeOf(t, it)
        val b = mesh.nodeOf(t, (it + 1) % 3)
        Predicates.orient(mesh.x(a), mesh.y(a), mesh.x(b), mesh.y(b), x, y) >= 0
    }

    private fun distance(edge: Int, x: Double, y: Double): Double {
        val a = mesh.edgeStart(edge)
        val b = mesh.edgeEnd(edge)
        return Distance.pointToSegment(Coordinate(x, y), Coordinate(mesh.x(a), mesh.y(a)), Coordinate(mesh.x(b), mesh.y(b)))
    }
}
