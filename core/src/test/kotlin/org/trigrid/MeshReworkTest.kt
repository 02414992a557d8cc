package org.trigrid

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.domain.Domain
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import org.trigrid.quality.QualityReport

class MeshReworkTest {
    private val ribbed: TriMesh = MeshGenerator.generate(
        Domain.builder().outer(doubleArrayOf(0.0, 0.0, 4.0, 0.0, 4.0, 3.0, 0.0, 3.0), "rim")
            .hole(doubleArrayOf(1.0, 1.0, 1.5, 1.0, 1.5, 1.5), "bore").embed(doubleArrayOf(2.0, 2.0, 3.0, 2.5), "rib").build()
            .respaced(0.25, 1.0),
        MeshOptions.builder().improve(false).maxSize(0.3).build(),
    ).mesh

    @Test
    fun `refining keeps nodes, area, tags and angles`() {
        val fine = MeshRework.refine(ribbed)
        assertEquals(emptyList<Any>(), MeshCheck.check(fine))
        assertEquals(4 * ribbed.elementCount, fine.elementCount)
        assertEquals(ribbed.nodeCount + ribbed.edgeCount, fine.nodeCount)
        assertArrayEquals(ribbed.xy, fine.xy.copyOf(ribbed.xy.size))
        assertEquals(2 * ribbed.taggedEdgeCount, fine.taggedEdgeCount)
        for (tag in ribbed.tags) assertEquals(2 * edges(ribbed, tag), edges(fine, tag), tag)
        assertEquals(QualityReport.of(ribbed).minQuality, QualityReport.of(fine).minQuality, 1e-6)
        assertEquals(area(ribbed), area(fine), 1e-12)
    }

    private fun edges(mesh: TriMesh, tag: String) = (0 until mesh.taggedEdgeCount).count { mesh.tags[mesh.edgeTag(it)] == tag }

    private fun area(mesh: TriMesh) = (0 until mesh.elementCount).sumOf { mesh.area(it) }

    @Test
    fun `middles may lie on a curve`() {
        val corners = 12
        val circle = DoubleArray(2 * corners) { if (it % 2 == 0) Math.cos(Math.PI * (it / 2) / 6) else Math.sin(Math.PI * (it / 2) / 6) }
        var mesh = MeshGenerator.generate(Domain.builder().outer(circle).build()).mesh
        val onCircle = EdgeMiddles { m, edge ->
            val x = m.x(m.edgeStart(edge)) + m.x(m.edgeEnd(edge))
            val y = m.y(m.edgeStart(edge)) + m.y(m.edgeEnd(edge))
            doubleArrayOf(x / Math.hypot(x, y), y / Math.hypot(x, y))
        }
        repeat(3) { mesh = MeshRework.refine(mesh, onCircle) }
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh))
        assertEquals(Math.PI, area(mesh), 0.01)
    }

    @Test
    fun `improving keeps boundary and embedded edges and makes better elements`() {
        val grids = (1L..3L).map { GridMeshes.shaken(12, 9, it) { i, j -> i in 4..5 && j in 3..4 }.mesh }
        for (mesh in grids + ribbed) {
            val better = MeshRework.improve(mesh)
            assertEquals(emptyList<Any>(), MeshCheck.check(better, mesh.outline()))
            val before = QualityReport.of(mesh)
            val after = QualityReport.of(better)
            assertTrue(after.meanQuality > before.meanQuality, "${after.meanQuality} > ${before.meanQuality}")
            assertTrue(after.minQuality >= before.minQuality, "${after.minQuality} >= ${before.minQuality}")
            assertEquals(named(mesh), named(better))
            assertTrue(better.elementCount in mesh.elementCount / 2..2 * mesh.elementCount)
        }
    }

    private fun named(mesh: TriMesh) = (0 until mesh.taggedEdgeCount).map { e ->
        listOf(mesh.edgeStart(e), mesh.edgeEnd(e)).map { mesh.x(it) to mesh.y(it) }.toSet() to mesh.tags[mesh.edgeTag(e)]
    }.toSet()

    @Test
    fun `a broken mesh is refused, and improving may be cancelled`() {
        val overlapping = TriMeshFactory.of(
            doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0), intArrayOf(0, 1, 2, 0, 1, 3), IntArray(0), IntArray(0), emptyList(), "x",
        )
        assertThrows(IllegalArgumentException::class.java) { MeshRework.improve(overlapping) }
        assertThrows(IllegalArgumentException::class.java) { MeshRework.refine(overlapping) }
        assertThrows(MeshingCancelledException::class.java) { MeshRework.improve(ribbed) { _, _ -> false } }
    }
}
