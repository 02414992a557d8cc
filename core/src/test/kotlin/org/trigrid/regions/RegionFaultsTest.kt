package org.trigrid.regions

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainBuilder
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Region
import org.trigrid.mesh.MeshCheck

class RegionFaultsTest {
    @Test
    fun `points of regions outside, on a segment, and of two regions in one part`() {
        requireFault(plate().region(2.0, 2.0, A), FaultKind.REGION_POINT, 2.0, 2.0)
        requireFault(plate().region(0.5, 0.0, A), FaultKind.REGION_POINT, 0.5, 0.0)
        requireFault(plate().region(0.2, 0.5, A).region(0.8, 0.5, B), FaultKind.REGION_POINT, 0.8, 0.5)
        requireFault(plate().embedLoop(square(0.4, 0.4, 0.2), "i").region(0.5, 0.4, A), FaultKind.REGION_POINT, 0.5, 0.4)
    }

    @Test
    fun `embedded points outside and on segments`() {
        requireFault(plate().embedPoint(1.5, 0.5, "p"), FaultKind.EMBEDDED_OUTSIDE, 1.5, 0.5)
        requireFault(plate().embedPoint(0.5, 0.0, "p"), FaultKind.TOUCHING, 0.5, 0.0)
        requireFault(plate().hole(square(0.4, 0.4, 0.2), "h").embedPoint(0.5, 0.5, "p"), FaultKind.EMBEDDED_OUTSIDE, 0.5, 0.5)
        requireFault(plate().embed(doubleArrayOf(0.2, 0.2, 0.6, 0.6), "l").embedPoint(0.5, 0.5, "p"), FaultKind.TOUCHING, 0.5, 0.5)
        requireFault(plate().embedPoint(Double.NaN, 0.5, "p"), FaultKind.NOT_A_NUMBER, Double.NaN, 0.5)
    }

    @Test
    fun `an interface that crosses the boundary, and lines that cross each other, are the only faults told`() {
        requireFault(plate().embed(doubleArrayOf(0.5, 0.5, 0.5, 1.5), "i").region(0.2, 0.2, A), FaultKind.CROSSING, 0.5, 1.0)
        requireFault(
            plate().embed(doubleArrayOf(0.25, 0.25, 0.75, 0.75), "i").embed(doubleArrayOf(0.25, 0.75, 0.75, 0.25), "j").region(0.5, 0.1, A),
            FaultKind.CROSSING, 0.5, 0.5,
        )
        val overlapping = Domain.builder().region(square(0.0, 0.0, 1.0), A).region(square(0.5, 0.5, 1.0), B).build()
        assertEquals(setOf(FaultKind.CROSSING), DomainCheck.check(overlapping).map { it.kind }.toSet())
        val open = Domain.builder().region(square(0.0, 0.0, 1.0), A).region(square(1.0, 0.5, 1.0), B).build()
        assertEquals(setOf(FaultKind.OVERLAP), DomainCheck.check(open).map { it.kind }.toSet())
        val notFinite = Domain.builder().region(square(0.0, Double.NaN, 1.0), A).build()
        assertEquals(setOf(FaultKind.NOT_A_NUMBER), DomainCheck.check(notFinite).map { it.kind }.toSet())
    }

    @Test
    fun `interfaces that touch in a node, three regions round one, a region in a hole`() {
        val touching = plate().embedLoop(square(0.2, 0.2, 0.3), "i").embedLoop(square(0.5, 0.5, 0.3), "j")
            .region(0.3, 0.3, A).region(0.6, 0.6, B)
        requireMeshed(touching, 0.09, 0.09)
        val island = plate().hole(square(0.2, 0.2, 0.6), "h").outer(square(0.4, 0.4, 0.2), "island").region(0.5, 0.5, A)
            .region(0.1, 0.1, B)
        requireMeshed(island, 0.04, 0.64)
        val deep = plate().loop(square(0.1, 0.1, 0.8)).loop(square(0.2, 0.2, 0.6)).loop(square(0.3, 0.3, 0.4))
            .region(0.15, 0.15, A).region(0.25, 0.25, B).region(0.35, 0.35, Region.of("C"))
        requireMeshed(deep, 0.28, 0.2)
        val fan = Domain.builder().region(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.5, 0.5), A).region(doubleArrayOf(1.0, 0.0, 1.0, 1.0, 0.5, 0.5), B)
            .region(doubleArrayOf(1.0, 1.0, 0.0, 1.0, 0.5, 0.5), Region.of("C"))
        requireMeshed(fan, 0.25, 0.25)
    }

    @Test
    fun `regions of one name must be one`() {
        val builder = plate().region(0.5, 0.5, A)
        assertThrows(IllegalArgumentException::class.java) { builder.region(0.6, 0.6, A.withMaxSize(0.1)) }
        assertThrows(IllegalArgumentException::class.java) { InnerParts.NONE.withRegion(A, 0.5, 0.5).withRegion(A.withMaterial(2), 0.1, 0.1) }
        val other = plate().regionName("A").build().with(InnerParts.NONE.withRegion(A.withMaterial(3), 0.5, 0.5))
        assertEquals(emptyList<Any>(), DomainCheck.check(other))
        assertEquals(listOf(A.withMaterial(3)), other.regions)
        val outlined = plate().regionName("A").region(square(0.2, 0.2, 0.3), A.withMaterial(3)).build()
        assertEquals(listOf(A.withMaterial(3)), outlined.regions)
        assertThrows(IllegalArgumentException::class.java) { A.withMaterial(-1) }
        assertThrows(IllegalArgumentException::class.java) { A.withMaxSize(Double.NaN) }
    }

    private fun requireFault(builder: DomainBuilder, kind: FaultKind, x: Double, y: Double) {
        val domain = builder.build()
        val fault = DomainCheck.check(domain).single()
        assertEquals(kind, fault.kind)
        assertEquals(x, fault.x, 1e-12)
        assertEquals(y, fault.y, 1e-12)
        assertThrows(InvalidDomainException::class.java) { MeshGenerator.generate(domain) }
    }

    private fun requireMeshed(builder: DomainBuilder, areaA: Double, areaB: Double) {
        val domain = builder.build()
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        val mesh = MeshGenerator.generate(domain).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        assertEquals(areaA, mesh.elementsIn("A").sumOf { mesh.area(it) }, 1e-12)
        assertEquals(areaB, mesh.elementsIn("B").sumOf { mesh.area(it) }, 1e-12)
    }

    private fun plate() = Domain.builder().outer(square(0.0, 0.0, 1.0), "rim")

    private fun square(x: Double, y: Double, side: Double) = doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)

    private companion object {
        val A = Region.of("A")
        val B = Region.of("B")
    }
}
