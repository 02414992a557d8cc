package org.trigrid.fem

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh

class LinearElementsTest {
    private val mesh = GridMeshes.shaken(9, 7, 5L) { i, j -> i in 3..4 && j == 3 }.mesh
    private val elements = LinearElements.of(mesh)

    @Test
    fun `each shape function is 1 at its corner and 0 at the others`() {
        for (t in 0 until mesh.elementCount) for (corner in 0..2) {
            val node = mesh.nodeOf(t, corner)
            val expected = DoubleArray(3) { if (it == corner) 1.0 else 0.0 }
            assertArrayEquals(expected, elements.weights(t, mesh.x(node), mesh.y(node)), 1e-12)
        }
    }

    @Test
    fun `the gradient of a linear field is found in every element`() {
        val field = DoubleArray(mesh.nodeCount) { 4 + 2 * mesh.x(it) - 3 * mesh.y(it) }
        val gradients = elements.gradientsOf(field)
        for (t in 0 until mesh.elementCount) {
            assertEquals(2.0, gradients[2 * t], 1e-10)
            assertEquals(-3.0, gradients[2 * t + 1], 1e-10)
        }
    }

    @Test
    fun `arrays say what the single questions say`() {
        val gradients = elements.gradients()
        for (t in 0 until mesh.elementCount) {
            assertEquals(mesh.area(t), elements.areas()[t])
            for (corner in 0..2) {
                assertEquals(elements.gradientX(t, corner), gradients[6 * t + 2 * corner])
                assertEquals(elements.gradientY(t, corner), gradients[6 * t + 2 * corner + 1])
            }
        }
    }

    @Test
    fun `the nodes share the area, each what its shape function integrates to`() {
        val areas = elements.nodeAreas()
        assertEquals(elements.areas().sum(), areas.sum(), 1e-10)
        val single = LinearElements.of(TriMesh.of(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 0.0, 2.0), intArrayOf(0, 1, 2)))
        assertArrayEquals(doubleArrayOf(1.0, 1.0, 1.0), single.nodeAreas(), 1e-15)
        assertArrayEquals(doubleArrayOf(-1.0 / 3, -0.5, 1.0 / 3, 0.0, 0.0, 0.5), single.gradients(), 1e-15)
    }

    @Test
    fun `a flat element and too few values are refused`() {
        val flat = TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 1.0, 2.0, 2.0), intArrayOf(0, 1, 2))
        assertThrows<IllegalArgumentException> { LinearElements.of(flat) }
        assertThrows<IllegalArgumentException> { elements.gradientsOf(DoubleArray(mesh.nodeCount - 1)) }
    }
}
