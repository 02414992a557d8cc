package org.trigrid

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainFrame
import org.trigrid.domain.LaidDomain
import org.trigrid.mesh.EdgeSet
import org.trigrid.mesh.LaidMesh
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MutableMesh
import org.trigrid.spacing.ConstrainedDelaunay

class FrameSafetyTest {
    private val unheard = Checkpoint.unheard()
    private val square = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 2.0, 1.0, 2.0, 2.0, 1.0, 2.0, 0.0, 2.0, 0.0, 1.0)

    @Test
    fun `a plain outline is meshed in its frame`() {
        assertNotNull(triangulation(Domain.of(square), 0))
        assertNotNull(triangulation(Domain.builder().loop(square).embedPoint(0.5, 0.7, "point").build(), 0))
    }

    @Test
    fun `gaps, slivers and points that the grid would close keep a domain from it, and it is meshed as it lies`() {
        for (gap in listOf(1e-10, 1e-12, 1e-15)) {
            val hostile = mapOf(
                "hole near a side" to Domain.builder().loop(square).hole(doubleArrayOf(0.3, gap, 0.8, gap, 0.5, 0.6)).build(),
                "slit" to Domain.builder().loop(square).hole(doubleArrayOf(0.3, 0.6, 0.9, 0.6, 0.6, 0.6 + gap)).build(),
                "two holes" to Domain.builder().loop(square).hole(doubleArrayOf(0.3, 0.3, 0.9, 0.3, 0.9, 0.9))
                    .hole(doubleArrayOf(0.3 - gap, 0.3, 0.9 - gap, 0.9, 0.3, 1.2)).build(),
                "point near a side" to Domain.builder().loop(square).embedPoint(0.5, gap, "point").build(),
                "node near a line" to Domain.builder().loop(square).embed(doubleArrayOf(gap, 1.1, 0.5, 1.0, 0.5, 1.5), "line").build(),
            )
            for ((what, domain) in hostile) {
                if (what != "slit") assertNull(triangulation(domain, 0), "$what of $gap")
                assertEquals(emptyList<Any>(), MeshCheck.check(MeshGenerator.generate(domain).mesh, domain)) { "$what of $gap" }
            }
        }
    }

    @Test
    fun `an element that is flat or folded is found`() {
        for ((y, isPositive) in listOf(0.1 to true, 0.0 to false, -0.1 to false)) {
            val mesh = MutableMesh(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.5, y), 3, DoubleArray(3) { 1.0 }, 1, EdgeSet(IntArray(0)))
            mesh.addElement(0, 1, 2)
            assertEquals(isPositive, LaidMesh.isPositive(mesh, unheard)) { "apex at $y" }
        }
    }

    private fun triangulation(domain: Domain, grid: Int): ConstrainedDelaunay? {
        val frames = DomainFrame(domain, unheard).frames()
        assertTrue(frames.size > grid)
        return FrameSafety(LaidDomain.inFrame(domain, frames[grid], unheard), frames[grid], unheard).triangulation()
    }
}
