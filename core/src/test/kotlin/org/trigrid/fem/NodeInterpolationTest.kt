package org.trigrid.fem

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.domain.Path
import org.trigrid.mesh.TriMesh
import org.trigrid.shape.Circle
import kotlin.random.Random

class NodeInterpolationTest {
    private val coarse = disc(0.3)
    private val interpolation = NodeInterpolation.of(coarse)
    private val field = DoubleArray(coarse.nodeCount) { linear(coarse.x(it), coarse.y(it)) }

    @Test
    fun `a linear field is found everywhere, and nothing outside`() {
        val random = Random(4)
        repeat(1000) {
            val x = random.nextDouble(-0.7, 0.7)
            val y = random.nextDouble(-0.7, 0.7)
            assertEquals(linear(x, y), interpolation.valueAt(field, x, y), 1e-12)
            assertEquals(interpolation.valueAt(field, x, y), interpolation.nearestValueAt(field, x, y))
        }
        assertTrue(interpolation.valueAt(field, 1.1, 0.0).isNaN())
        for (node in 0 until coarse.nodeCount) {
            assertEquals(field[node], interpolation.valueAt(field, coarse.x(node), coarse.y(node)), 1e-14)
        }
    }

    @Test
    fun `beyond the boundary the nearest value holds`() {
        val east = coarse.nodesOn("rim").first { coarse.x(it) == 1.0 }
        assertEquals(field[east], interpolation.nearestValueAt(field, 3.0, 0.0), 1e-14)
    }

    @Test
    fun `a field carried to a finer mesh keeps its range and is right up to the gap at the boundary`() {
        val fine = disc(0.05)
        val carried = interpolation.carriedTo(fine, field)
        // A chord of 0.3 on the circle of radius 1 has its middle this far inside; the field's slope is 5.
        val gap = 1 - Math.sqrt(1 - 0.15 * 0.15)
        var beyond = 0
        for (node in 0 until fine.nodeCount) {
            assertEquals(linear(fine.x(node), fine.y(node)), carried[node], 5.1 * gap)
            if (interpolation.valueAt(field, fine.x(node), fine.y(node)).isNaN()) beyond++
        }
        assertTrue(beyond > 50, "nodes of the finer mesh outside of the coarse one: $beyond")
        assertTrue(carried.min() >= field.min() && carried.max() <= field.max())
    }

    @Test
    fun `too few values are refused`() {
        assertThrows<IllegalArgumentException> { interpolation.valueAt(DoubleArray(3), 0.0, 0.0) }
        assertThrows<IllegalArgumentException> { interpolation.nearestValueAt(DoubleArray(3), 0.0, 0.0) }
    }

    private fun disc(spacing: Double): TriMesh =
        MeshGenerator.generate(Path.of(Circle(0.0, 0.0, 1.0, spacing).withName("rim")).toDomain()).mesh

    private fun linear(x: Double, y: Double) = 1 + 3 * x - 4 * y
}
