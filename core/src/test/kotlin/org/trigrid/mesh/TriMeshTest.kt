package org.trigrid.mesh

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TriMeshTest {
    @Test
    fun `edges, bandwidth and area of two elements by hand`() {
        val mesh = TriMesh.of(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 2.0, 1.0, 0.0, 1.0), intArrayOf(0, 1, 2, 0, 3, 2))
        // The second element was given clockwise.
        assertArrayEquals(intArrayOf(0, 1, 2, 0, 2, 3), mesh.elementNodes())
        assertEquals(5, mesh.edgeCount)
        assertEquals(setOf(0 to 1, 1 to 2, 0 to 2, 2 to 3, 0 to 3), mesh.edgeNodes().toList().chunked(2) { it[0] to it[1] }.toSet())
        assertEquals(3, mesh.halfBandwidth)
        assertEquals(7, mesh.bandwidth)
        assertEquals(1.0, mesh.area(0) + mesh.area(1) - 1.0)
        assertEquals(1, mesh.neighbourOf(0, 2))
        assertEquals(TriMesh.NONE, mesh.neighbourOf(0, 0))
        assertArrayEquals(intArrayOf(0, 1, 2, 3), mesh.nodesOn("boundary"))
    }

    @Test
    fun `renumbering keeps the mesh and orders its elements`() {
        for (seed in 1L..20L) {
            val grid = GridMeshes.shaken(8, 6, seed) { i, j -> i == 3 && j in 2..3 }
            val order = GridMeshes.randomPermutation(grid.mesh.nodeCount, java.util.Random(seed))
            val other = grid.mesh.renumbered(order)
            assertEquals(emptyList<MeshViolation>(), MeshCheck.check(other, grid.domain))
            for (node in order.indices) {
                assertEquals(grid.mesh.x(node), other.x(order[node]))
                assertEquals(grid.mesh.kindOf(node), other.kindOf(order[node]))
            }
            val lowest = (0 until other.elementCount).map { t -> (0..2).minOf { other.nodeOf(t, it) } }
            assertEquals(lowest.sorted(), lowest)
            assertEquals(grid.mesh.nodesOn("along x").map { order[it] }.sorted(), other.nodesOn("along x").toList())
        }
    }

    @Test
    fun `the edges of a group are those with its tag`() {
        val mesh = GridMeshes.shaken(8, 6, 1L) { i, j -> i == 3 && j in 2..3 }.mesh
        assertEquals(mesh.taggedEdgeCount, mesh.tags.sumOf { mesh.edgesOn(it).size })
        for (tag in mesh.tags) {
            assertTrue(mesh.edgesOn(tag).isNotEmpty())
            for (edge in mesh.edgesOn(tag)) assertEquals(tag, mesh.tags[mesh.edgeTag(edge)])
            val ends = mesh.edgesOn(tag).flatMap { listOf(mesh.edgeStart(it), mesh.edgeEnd(it)) }
            assertEquals(ends.distinct().sorted(), mesh.nodesOn(tag).toList())
        }
        assertEquals(0, mesh.edgesOn("elsewhere").size)
    }

    @Test
    fun `what is no permutation or no mesh is refused`() {
        val mesh = GridMeshes.grid(2, 2).mesh
        assertThrows(IllegalArgumentException::class.java) { mesh.renumbered(IntArray(mesh.nodeCount)) }
        assertThrows(IllegalArgumentException::class.java) { mesh.renumbered(IntArray(3) { it }) }
        assertThrows(IllegalArgumentException::class.java) { TriMesh.of(DoubleArray(6), intArrayOf(0, 1, 3)) }
        assertThrows(IllegalArgumentException::class.java) { TriMesh.of(DoubleArray(5), intArrayOf(0, 1, 2)) }
    }
}
