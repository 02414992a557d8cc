package org.trigrid.regions

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshRework
import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MeshParts
import org.trigrid.mesh.MeshViolationKind
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

class RegionCheckTest {
    private val domain = Domain.builder().region(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), Region.of("a"))
        .region(doubleArrayOf(1.0, 0.0, 2.0, 0.0, 2.0, 1.0, 1.0, 1.0), Region.of("b")).embedPoint(0.5, 0.4, "p").build()
    private val mesh = MeshGenerator.generate(domain).mesh

    @Test
    fun `an element of another region, regions that are swapped or missing, and a lost point are found`() {
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        val regions = IntArray(mesh.elementCount) { mesh.regionOf(it) }
        val one = regions.copyOf().also { it[0] = 1 - it[0] }
        assertTrue(kinds(with(one, mesh.parts.points)).contains(MeshViolationKind.WRONG_REGION))
        val swapped = with(IntArray(regions.size) { 1 - regions[it] }, mesh.parts.points)
        assertEquals(emptyList<Any>(), MeshCheck.check(swapped))
        assertEquals(setOf(MeshViolationKind.WRONG_REGION), MeshCheck.check(swapped, domain).map { it.kind }.toSet())
        assertEquals(setOf(MeshViolationKind.WRONG_REGION), kinds(with(regions.copyOf(2), mesh.parts.points)))
        assertEquals(setOf(MeshViolationKind.WRONG_REGION), kinds(with(regions.copyOf().also { it[0] = 7 }, mesh.parts.points)) - setOf(MeshViolationKind.EULER))
        assertEquals(setOf(MeshViolationKind.GIVEN_NODE), MeshCheck.check(with(regions, IntArray(0)), domain).map { it.kind }.toSet())
    }

    @Test
    fun `edges between the regions of plain arrays are tagged`() {
        val made = TriMesh.of(
            doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), intArrayOf(0, 1, 2, 0, 2, 3), listOf(Region.of("a"), Region.of("b")), intArrayOf(0, 1),
        )
        assertEquals(emptyList<Any>(), MeshCheck.check(made))
        assertEquals(1, made.edgesOn("interface").size)
        assertEquals(listOf("a", "b"), made.outline().regions.map { it.name })
        assertThrows(IllegalArgumentException::class.java) {
            TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0), intArrayOf(0, 1, 2), listOf(Region.of("a")), intArrayOf(1))
        }
    }

    @Test
    fun `elements of six nodes keep regions and points`() {
        val quadratic: QuadraticMesh = MeshRework.secondOrder(mesh)
        val area = (0 until quadratic.elementCount).filter { quadratic.regions[quadratic.regionOf(it)].name == "b" }.sumOf { quadratic.area(it) }
        assertEquals(1.0, area, 1e-12)
        assertEquals(0.4, quadratic.y(quadratic.pointNode(0)))
        assertEquals(quadratic.pointNode(0), quadratic.nodesOn("p").single())
    }

    private fun kinds(mesh: TriMesh) = MeshCheck.check(mesh).map { it.kind }.toSet()

    private fun with(regions: IntArray, points: IntArray) = TriMesh(
        mesh.xy, mesh.elements, mesh.neighbours, mesh.kinds, mesh.edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags,
        MeshParts(mesh.regions, regions, points, if (points.isEmpty()) points else mesh.parts.pointTags),
    )
}
