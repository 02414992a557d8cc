package org.trigrid.spacing

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.domain.Domain

class SizeDeviationTest {
    private val square = Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0))

    @Test
    fun `the diagonal of a unit square is half a binary order longer than its sides`() {
        assertEquals(0.5, SizeDeviation.of(MeshGenerator.generate(square).mesh, square), 1e-12)
    }

    @Test
    fun `a triangle has no inner edges`() {
        val triangle = Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0))
        assertTrue(SizeDeviation.of(MeshGenerator.generate(triangle).mesh, triangle).isNaN())
    }

    @Test
    fun `edges of half the size asked for are one binary order off`() {
        val domain = square.respaced(0.05, 1.0)
        val asked = MeshGenerator.generate(domain).mesh
        val halved = MeshGenerator.generate(domain, MeshOptions.builder().maxSize(0.025).gradation(2.0).build()).mesh
        assertTrue(SizeDeviation.of(asked, domain) < 0.1)
        assertEquals(1.0, SizeDeviation.of(halved, domain), 0.25)
    }
}
