package org.trigrid.regions

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshRework
import org.trigrid.MeshResult
import org.trigrid.domain.Domain
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.NodeKind
import org.trigrid.reliability.RandomLoops.subdivided
import org.trigrid.spacing.Sizes
import java.util.Random

class EmbeddedPointsTest {
    @Test
    fun `random points and lines are nodes and edges of the mesh`() {
        for (seed in 0 until 60) {
            val r = Random(31L * seed)
            val builder = Domain.builder().outer(subdivided(SQUARE, 4 + r.nextInt(20)), "rim")
            val count = 1 + r.nextInt(if (seed % 10 == 0) 200 else 8)
            val points = DoubleArray(2 * count) { 0.05 + 0.9 * r.nextDouble() }
            for (p in 0 until count) builder.embedPoint(points[2 * p], points[2 * p + 1], "p${p % 3}")
            if (r.nextBoolean()) builder.embed(doubleArrayOf(0.2, 0.31, 0.5, 0.34, 0.8, 0.29), "line")
            val domain = builder.build()
            val options = MeshOptions.builder().strategy(if (seed % 4 == 0) Strategy.CLASSIC else Strategy.ROBUST)
                .improve(seed % 3 != 0).sizes(if (seed % 2 == 0) Sizes.SMOOTH else Sizes.GRADE).build()
            val mesh = MeshGenerator.generate(domain, options).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain), "seed $seed")
            assertEquals(count, mesh.pointCount)
            for (p in 0 until count) {
                val node = mesh.pointNode(p)
                assertEquals(points[2 * p], mesh.x(node))
                assertEquals(points[2 * p + 1], mesh.y(node))
                assertEquals(NodeKind.EMBEDDED, mesh.kindOf(node))
                assertTrue(node in mesh.nodesOn("p${p % 3}"))
            }
            val improved = MeshRework.improve(mesh)
            assertEquals(emptyList<Any>(), MeshCheck.check(improved, domain), "seed $seed, improved")
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, mesh.outline()), "seed $seed, outline")
        }
    }

    @Test
    fun `a point costs little quality and has elements of the field's size`() {
        val r = Random(5)
        val plain = MeshGenerator.generate(plate().build())
        var worst = 1.0
        repeat(30) {
            val x = 0.2 + 0.6 * r.nextDouble()
            val y = 0.2 + 0.6 * r.nextDouble()
            val made = MeshGenerator.generate(plate().embedPoint(x, y, "probe").build())
            worst = Math.min(worst, made.report.quality.minQuality)
            assertTrue(made.report.quality.meanQuality > plain.report.quality.meanQuality - 0.004) { "${made.report.quality.meanQuality}" }
            assertTrue(Math.abs(made.mesh.elementCount - plain.mesh.elementCount) < 0.05 * plain.mesh.elementCount)
            for (length in lengthsAt(made)) assertTrue(length in 0.03..0.08) { "$length" }
        }
        assertTrue(worst > 0.6) { "$worst" }
    }

    @Test
    fun `two points close together have small elements between them and the usual ones elsewhere`() {
        val domain = plate().embedPoint(0.5, 0.5, "a").embedPoint(0.502, 0.5, "b").build()
        val made = MeshGenerator.generate(domain)
        assertEquals(emptyList<Any>(), MeshCheck.check(made.mesh, domain))
        assertTrue(lengthsAt(made).min() < 0.0021)
        assertTrue(made.report.quality.minQuality > 0.5) { "${made.report.quality.minQuality}" }
        assertTrue(made.mesh.elementCount in 900..2500) { "${made.mesh.elementCount}" }
    }

    @Test
    fun `a point at a node of the boundary stays that node`() {
        val domain = plate().embedPoint(0.5, 0.0, "probe").build()
        val mesh = MeshGenerator.generate(domain).mesh
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain))
        assertEquals(NodeKind.BOUNDARY, mesh.kindOf(mesh.pointNode(0)))
        assertEquals(0.5, mesh.x(mesh.nodesOn("probe").single()))
    }

    @Test
    fun `a lattice of points far finer than the sizes is kept`() {
        val builder = plate()
        for (i in 0 until 100) builder.embedPoint(0.4 + 0.001 * (i % 10), 0.4 + 0.001 * (i / 10), "lattice")
        val domain = builder.build()
        val made = MeshGenerator.generate(domain)
        assertEquals(emptyList<Any>(), MeshCheck.check(made.mesh, domain))
        assertTrue(made.report.quality.minQuality > 0.5) { "${made.report.quality.minQuality}" }
    }

    @Test
    fun `many points at random places leave good elements, near a coarse boundary too`() {
        val r = Random(9)
        val builder = plate()
        repeat(2000) { builder.embedPoint(0.05 + 0.9 * r.nextDouble(), 0.05 + 0.9 * r.nextDouble(), "p") }
        val domain = builder.build()
        val made = MeshGenerator.generate(domain)
        assertEquals(emptyList<Any>(), MeshCheck.check(made.mesh, domain))
        assertTrue(made.report.quality.minQuality > 0.5) { "${made.report.quality.minQuality}" }
    }

    private fun plate() = Domain.builder().outer(subdivided(SQUARE, 20), "rim")

    private fun lengthsAt(made: MeshResult): List<Double> {
        val mesh = made.mesh
        val node = mesh.pointNode(0)
        val edges = mesh.edgeNodes()
        return (0 until mesh.edgeCount).filter { edges[2 * it] == node || edges[2 * it + 1] == node }
            .map { Math.hypot(mesh.x(edges[2 * it]) - mesh.x(edges[2 * it + 1]), mesh.y(edges[2 * it]) - mesh.y(edges[2 * it + 1])) }
    }

    private companion object {
        val SQUARE = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0)
    }
}
