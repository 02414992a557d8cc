package org.trigrid

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.assertThrows
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.domain.Domain
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.NodeKind
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes
import java.io.ByteArrayOutputStream
import java.io.ObjectInputStream
import java.io.ObjectOutputStream

class MeshGeneratorTest {
    @TestFactory
    fun `every family of random domains is meshed validly in every mode`(): List<DynamicTest> =
        RandomDomains.small.map { family ->
            DynamicTest.dynamicTest(family.name) {
                for (seed in 1L until 5L step 3) if (family.every == 1 || seed == 1L) meshInAllModes(family, seed)
            }
        }

    @Tag("corpus")
    @TestFactory
    fun `many random domains are meshed validly in every mode`(): List<DynamicTest> =
        RandomDomains.families.map { family ->
            DynamicTest.dynamicTest(family.name) {
                for (seed in 1000L until 1030L) if (seed % family.every == 0L) meshInAllModes(family, seed)
            }
        }

    private fun meshInAllModes(family: RandomDomains.Family, seed: Long) {
        val domain = family.make(seed)
        for (strategy in Strategy.entries) {
            for (sizes in Sizes.entries) {
                val options = MeshOptions.builder().strategy(strategy).sizes(sizes).build()
                val result = MeshGenerator.generate(domain, options)
                val violations = MeshCheck.check(result.mesh, domain)
                assertTrue(violations.isEmpty()) { "${family.name} $seed $strategy $sizes: ${violations.first()}" }
                val report = result.report
                assertTrue(report.numberingAfter.halfBandwidth <= report.numberingBefore.halfBandwidth)
            }
        }
    }

    @Test
    fun `the elements expected are those of the report, and options travel`() {
        val options = MeshOptions.builder().sizes(Sizes.GRADE).gradation(0.4).maxSize(0.3).strategy(Strategy.CLASSIC)
            .sizeSources(SizeSources.NONE.withPoint(0.01, 0.5, 0.5)).build()
        val bytes = ByteArrayOutputStream()
        ObjectOutputStream(bytes).use { it.writeObject(options) }
        val read = ObjectInputStream(bytes.toByteArray().inputStream()).use { it.readObject() as MeshOptions }
        val report = MeshGenerator.generate(square(20), options).report
        assertEquals(report.expectedElements, MeshGenerator.expectedElements(square(20), read))
        assertEquals(report.elementCount, MeshGenerator.generate(square(20), read).report.elementCount)
        val line = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1.0, 0.0), "edge").build()
        assertThrows<InvalidDomainException> { MeshGenerator.expectedElements(line, options) }
    }

    @Test
    fun `a square of equal spacing becomes a regular mesh`() {
        val result = MeshGenerator.generate(square(20))
        val report = result.report
        // 4 / sqrt(3) / h^2 elements fill a square of side 1.
        assertEquals(923.8, report.elementCount.toDouble(), 60.0)
        assertEquals(80, report.boundaryNodeCount)
        assertEquals(1, report.loopCount)
        assertEquals(0, report.fallbacks)
        assertTrue(report.quality.minAngle > 30) { "smallest angle ${report.quality.minAngle}" }
        assertTrue(report.quality.meanQuality > 0.98) { "mean quality ${report.quality.meanQuality}" }
        assertEquals(report.elementCount, 2 * report.nodeCount - report.boundaryNodeCount - 2)
    }

    @Test
    fun `given nodes stay exactly where they are`() {
        val domain = RandomDomains.families.first { it.name == "uneven with holes" }.make(3)
        val mesh = MeshGenerator.generate(domain).mesh
        val places = (0 until mesh.nodeCount).filter { mesh.kindOf(it) == NodeKind.BOUNDARY }
            .map { mesh.x(it) to mesh.y(it) }.toSet()
        assertEquals((0 until domain.nodeCount).map { domain.x(it) to domain.y(it) }.toSet(), places)
    }

    @Test
    fun `the same input gives the same mesh`() {
        val domain = RandomDomains.families.first { it.name == "star with holes" }.make(5)
        assertSame(MeshGenerator.generate(domain).mesh, MeshGenerator.generate(domain).mesh, 1.0)
    }

    @Test
    fun `two threads with the same options get the same mesh`() {
        val domain = RandomDomains.families.first { it.name == "uneven with holes" }.make(8)
        val options = MeshOptions.builder().gradation(0.2).build()
        val expected = MeshGenerator.generate(domain, options).mesh
        val pool = java.util.concurrent.Executors.newFixedThreadPool(2)
        val runs = List(4) { pool.submit<TriMesh> { MeshGenerator.generate(domain, options).mesh } }
        runs.forEach { assertSame(expected, it.get(), 1.0) }
        pool.shutdown()
    }

    @Test
    fun `scaling by a power of two scales the mesh bit for bit`() {
        for (family in RandomDomains.small) {
            val domain = family.make(2)
            val mesh = MeshGenerator.generate(domain).mesh
            for (scale in listOf(1048576.0, 1.0 / 1048576.0)) {
                val scaled = Domain(
                    DoubleArray(domain.xy.size) { scale * domain.xy[it] },
                    domain.segments, domain.segmentTags, domain.embedded, domain.tags, domain.regionMap, domain.points,
                )
                assertSame(mesh, MeshGenerator.generate(scaled).mesh, scale)
            }
        }
    }

    @Test
    fun `progress never falls and ends at one`() {
        val told = ArrayList<Double>()
        val stages = LinkedHashSet<Stage>()
        MeshGenerator.generate(square(60), MeshOptions.DEFAULT) { stage, fraction ->
            stages.add(stage)
            told.add(fraction)
            true
        }
        assertEquals(told.sorted(), told)
        assertEquals(1.0, told.last())
        assertEquals(Stage.entries, stages.toList())
    }

    @Test
    fun `cancelling at any stage ends the run`() {
        for (stage in Stage.entries) {
            val monitor = ProgressMonitor { at, _ -> at != stage }
            assertThrows<MeshingCancelledException> { MeshGenerator.generate(square(20), MeshOptions.DEFAULT, monitor) }
        }
    }

    @Test
    fun `a faulty domain is refused with every fault`() {
        val bow = doubleArrayOf(0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0)
        val domain = Domain.builder().outer(bow).build()
        val exception = assertThrows<InvalidDomainException> { MeshGenerator.generate(domain) }
        val crossing = exception.faults.first { it.kind == FaultKind.CROSSING }
        assertEquals(0.5, crossing.x, 1e-12)
        assertEquals(0.5, crossing.y, 1e-12)
    }

    @Test
    fun `a domain that would need too many elements is refused before meshing`() {
        val options = MeshOptions.builder().maxElements(100).build()
        val exception = assertThrows<TooManyElementsException> { MeshGenerator.generate(square(50), options) }
        assertTrue(exception.message!!.contains("the limit is 100")) { exception.message!! }
    }

    @Test
    fun `without improvement and renumbering the mesh is valid too`() {
        val options = MeshOptions.builder().improve(false).numbering(NumberingMethod.NONE).build()
        for (family in RandomDomains.small) {
            val domain = family.make(1)
            val result = MeshGenerator.generate(domain, options)
            assertEquals(emptyList<Any>(), MeshCheck.check(result.mesh, domain))
            assertEquals(result.report.numberingBefore.profile, result.report.numberingAfter.profile)
        }
    }

    private fun square(n: Int): Domain {
        val corners = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0)
        val xy = DoubleArray(8 * n) {
            val side = it / 2 / n
            val t = it / 2 % n / n.toDouble()
            val from = corners[2 * side + it % 2]
            from + t * (corners[(2 * side + 2) % 8 + it % 2] - from)
        }
        return Domain.builder().outer(xy).build()
    }

    private fun assertSame(expected: TriMesh, actual: TriMesh, scale: Double) {
        assertArrayEquals(expected.elementNodes(), actual.elementNodes())
        assertArrayEquals(expected.nodeCoordinates().map { scale * it }.toDoubleArray(), actual.nodeCoordinates())
    }
}
