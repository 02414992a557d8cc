package org.trigrid.regions

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshRework
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.Region
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.reliability.RandomLoops.placed
import org.trigrid.reliability.RandomLoops.ring
import org.trigrid.reliability.RandomLoops.subdivided

class RegionMeshTest {
    @Test
    fun `random regions have their areas, and meet at their interfaces only`() {
        for (seed in 0 until 120) {
            val expected = RegionDomains.make(seed)
            val what = "${expected.name} $seed"
            assertEquals(emptyList<Any>(), DomainCheck.check(expected.domain), what)
            val strategy = if (seed % 5 == 0) Strategy.CLASSIC else Strategy.ROBUST
            val mesh = MeshGenerator.generate(expected.domain, MeshOptions.builder().strategy(strategy).build()).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, expected.domain), what)
            requireAreas(mesh, expected.areas, what)
            requireInterfaces(mesh, expected.domain, what)
            requireAreas(MeshRework.improve(mesh), expected.areas, what)
            val fine = MeshRework.refine(mesh)
            assertEquals(emptyList<Any>(), MeshCheck.check(fine), what)
            requireAreas(fine, expected.areas, what)
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, mesh.outline()), what)
        }
    }

    private fun requireAreas(mesh: TriMesh, areas: Map<String, Double>, what: String) {
        assertEquals(areas.keys, mesh.regions.map { it.name }.toSet(), what)
        for ((name, area) in areas) assertEquals(area, mesh.elementsIn(name).sumOf { mesh.area(it) }, 1e-9 * area + 1e-12, "$what $name")
    }

    /** Each pair of neighbours of different regions lies at an interface of the domain, and there are as many as it has. */
    private fun requireInterfaces(mesh: TriMesh, domain: Domain, what: String) {
        var pairs = 0
        for (t in 0 until mesh.elementCount) for (k in 0..2) {
            val across = mesh.neighbourOf(t, k)
            if (across > t && mesh.regionOf(across) != mesh.regionOf(t)) pairs++
        }
        assertEquals((0 until domain.segmentCount).count { domain.isInterface(it) }, pairs, what)
    }

    @Test
    fun `a hole with the point of a region in it is filled, another stays`() {
        val domain = Domain.builder().outer(subdivided(SQUARE, 10), "rim").regionName("iron")
            .hole(placed(ring(16), -0.4, 0.0, 0.2), "slot").hole(placed(ring(16), 0.4, 0.0, 0.2), "hole")
            .region(-0.4, 0.0, Region.of("copper").withMaterial(29)).build()
        assertEquals(listOf("iron", "copper"), domain.regions.map { it.name })
        assertEquals(2, domain.loopCount)
        val mesh = MeshGenerator.generate(domain).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        assertEquals(16, mesh.edgesOn("slot").size)
        assertTrue(mesh.edgesOn("slot").all { it >= mesh.boundaryEdgeCount })
        assertTrue(mesh.edgesOn("hole").all { it < mesh.boundaryEdgeCount })
        assertEquals(29, mesh.regions[1].material)
    }

    @Test
    fun `the largest size of a region holds there and not beside it`() {
        val coarse = Region.of("coarse")
        val fine = Region.of("fine").withMaxSize(0.02)
        val domain = Domain.builder()
            .region(RegionDomains.divided(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), 10), coarse, "left")
            .region(RegionDomains.divided(doubleArrayOf(1.0, 0.0, 2.0, 0.0, 2.0, 1.0, 1.0, 1.0), 10), fine, "right").build()
        val mesh = MeshGenerator.generate(domain).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        val of = { name: String -> mesh.elementsIn(name).size }
        assertTrue(of("coarse") in 200..300) { "${of("coarse")}" }
        assertTrue(of("fine") > 6 * of("coarse")) { "${of("fine")}" }
    }

    @Test
    fun `the largest size of a region holds however the domain lies`() {
        val line = doubleArrayOf(0.3, 0.0, 0.35, 0.25, 0.3, 0.5, 0.4, 0.75, 0.5, 1.0)
        for (pose in 0 until 8) {
            fun laid(xy: DoubleArray) = DoubleArray(xy.size) {
                val x = if (pose >= 4) -xy[it - it % 2] else xy[it - it % 2]
                val y = xy[it - it % 2 + 1]
                listOf(listOf(x, y), listOf(-y, x), listOf(-x, -y), listOf(y, -x))[pose % 4][it % 2]
            }
            val left = laid(doubleArrayOf(0.1, 0.3))
            val plate = doubleArrayOf(0.0, 0.0, 0.3, 0.0, 1.0, 0.0, 1.0, 1.0, 0.5, 1.0, 0.0, 1.0)
            val domain = Domain.builder().regionName("right").outer(laid(plate)).embed(laid(line), "cut")
                .region(left[0], left[1], Region.of("left").withMaxSize(0.02)).build()
            val mesh = MeshGenerator.generate(domain, MeshOptions.builder().gradation(2.0).build()).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
            val share = mesh.elementsIn("left").size.toDouble() / mesh.elementCount
            assertTrue(share > 0.7) { "pose $pose: $share of ${mesh.elementCount}" }
        }
    }

    @Test
    fun `a region meshed beside another is as good as one alone`() {
        val disc = placed(ring(60), 0.0, 0.0, 0.5)
        val plate = subdivided(SQUARE, 40)
        val both = Domain.builder().outer(plate, "rim").region(disc, Region.of("disc"), "interface").build()
        val whole = MeshGenerator.generate(both).report.quality
        val parts = listOf(
            MeshGenerator.generate(Domain.builder().outer(plate).hole(disc).build()).report.quality,
            MeshGenerator.generate(Domain.of(disc)).report.quality,
        )
        assertTrue(whole.meanQuality > parts.minOf { it.meanQuality } - 0.002) { "${whole.meanQuality} ${parts.map { it.meanQuality }}" }
        assertTrue(whole.minQuality > 0.9 * parts.minOf { it.minQuality }) { "${whole.minQuality} ${parts.map { it.minQuality }}" }
    }

    private companion object {
        val SQUARE = doubleArrayOf(-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0)
    }
}
