package org.trigrid.improve

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.RandomDomains
import org.trigrid.StageClock
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.domain.Domain
import org.trigrid.front.FrontMesher
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MeshFreezer
import org.trigrid.mesh.MeshLocality
import org.trigrid.mesh.MutableMesh
import org.trigrid.mesh.TriMesh
import org.trigrid.parallel.Crew
import org.trigrid.quality.QualityReport
import org.trigrid.reliability.RandomLoops
import org.trigrid.spacing.ConstrainedDelaunay
import org.trigrid.spacing.SizeFields
import org.trigrid.spacing.SizeRules
import org.trigrid.spacing.Sizes
import java.util.concurrent.Executors

class DividedImprovementTest {
    private val rules = SizeRules(Sizes.SMOOTH, 0.25, 0.0, Double.POSITIVE_INFINITY, null)

    private fun raw(domain: Domain): MutableMesh {
        val triangulation = ConstrainedDelaunay.of(domain)
        val sizes = SizeFields.create(domain, rules, triangulation)
        val expected = SizeFields.estimateElements(triangulation, sizes)
        val mesh = FrontMesher.mesh(domain, sizes, Strategy.ROBUST, expected, ProgressMonitor.NONE).mesh
        MeshLocality.arrange(mesh)
        return mesh
    }

    private fun divided(domain: Domain, parts: Int, crew: Crew = Crew.CALLER): TriMesh {
        val mesh = raw(domain)
        DividedImprovement(mesh, 0.01, crew) {}.run(parts)
        return MeshFreezer.freeze(mesh, domain)
    }

    @Test
    fun `any domain in any number of parts gets a valid mesh`() {
        for (family in RandomDomains.small) {
            val domain = family.make(3)
            for (parts in intArrayOf(2, 19)) {
                val mesh = divided(domain, parts)
                assertEquals(emptyList<Any>(), MeshCheck.check(mesh, domain)) { "${family.name} in $parts parts" }
            }
        }
    }

    @Test
    fun `seams do not show in the quality`() {
        val domain = Domain.of(RandomLoops.subdivided(RandomLoops.square(0.0, 0.0, 1.0), 60))
        val whole = raw(domain).also { MeshImprover(it, 0.01).run() }
        val expected = QualityReport.of(MeshFreezer.freeze(whole, domain))
        val found = QualityReport.of(divided(domain, 8))
        assertTrue(found.meanQuality > expected.meanQuality - 0.002) { "mean q ${found.meanQuality}, undivided ${expected.meanQuality}" }
        assertTrue(found.minAngle > expected.minAngle - 5) { "min angle ${found.minAngle}, undivided ${expected.minAngle}" }
    }

    @Test
    fun `the mesh does not depend on the threads`() {
        val domain = RandomDomains.families.first { it.name == "hundreds of holes" }.make(1)
        val expected = divided(domain, 7)
        val pool = Executors.newFixedThreadPool(3)
        val found = divided(domain, 7, Crew(3, pool))
        pool.shutdown()
        assertArrayEquals(expected.xy, found.xy)
        assertArrayEquals(expected.elements, found.elements)
    }

    @Test
    fun `a large mesh does not depend on the threads either, and can be cancelled at any time`() {
        val domain = Domain.of(RandomLoops.subdivided(RandomLoops.square(0.0, 0.0, 1.0), 265))
        val pool = Executors.newFixedThreadPool(2)
        val shared = MeshOptions.builder().threads(3).executor(pool).build()
        val expected = MeshGenerator.generate(domain)
        val found = MeshGenerator.generate(domain, shared)
        assertTrue(expected.mesh.elementCount > 150_000) { "too few elements to be divided: ${expected.mesh.elementCount}" }
        assertArrayEquals(expected.mesh.xy, found.mesh.xy)
        assertArrayEquals(expected.mesh.elements, found.mesh.elements)
        assertEquals(expected.report.quality.meanQuality, found.report.quality.meanQuality)
        for (last in doubleArrayOf(0.45, 0.6, 0.83)) {
            var told = 0.0
            val monitor = ProgressMonitor { stage, fraction ->
                assertTrue(fraction >= told)
                told = fraction
                stage != Stage.IMPROVE || fraction < last
            }
            assertThrows<MeshingCancelledException> { MeshGenerator.run(domain, shared, StageClock(monitor, 0), null) }
        }
        pool.shutdown()
    }
}
