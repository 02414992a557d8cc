package org.trigrid.reliability

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshResult
import org.trigrid.RandomDomains
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.front.Strategy
import org.trigrid.io.WktReader
import org.trigrid.mesh.MeshCheck
import org.trigrid.project.ProjectFile
import org.trigrid.spacing.ConstrainedDelaunay
import org.trigrid.spacing.SizeFields
import org.trigrid.spacing.SizeRules
import org.trigrid.spacing.Sizes
import org.trigrid.spacing.TriangleWalk
import java.util.Random

/** What the runs over random domains and damaged files have brought to light, each with its domain or text. */
class FoundDefectsTest {
    @Test
    fun `a place behind a hole is found from wherever the search begins`() {
        val domain = RandomDomains.families.first { it.name == "plate of holes" }.make(14)
        val mesh = ConstrainedDelaunay.of(domain)
        val walk = TriangleWalk(mesh)
        val random = Random(1)
        for (t in 0 until mesh.triangleCount) {
            val corners = IntArray(3) { mesh.nodes[3 * t + it] }
            val x = corners.sumOf { mesh.xy[2 * it] } / 3
            val y = corners.sumOf { mesh.xy[2 * it + 1] } / 3
            assertEquals(t, walk.find(x, y, random.nextInt(mesh.triangleCount)))
            assertTrue(walk.reached)
        }
    }

    @Test
    fun `among holes there are as many elements as the sizes ask for`() {
        // Wrong sizes, taken from beyond the holes, once made four times as many.
        for ((name, seed) in listOf("plate of holes" to 14L, "star with holes" to 25L)) {
            val report = checkedMesh(name, seed).report
            assertTrue(report.elementCount < 1.3 * report.expectedElements) { "$name: ${report.elementCount}" }
            assertTrue(report.fallbacks < 50) { "$name: ${report.fallbacks}" }
        }
    }

    @Test
    fun `needles are valid although rounding leaves little of their area`() {
        for (seed in listOf(18L, 1064L, 1069L, 2120L)) checkedMesh("needle fan", seed)
    }

    @Test
    fun `edges of one ulp are found by the front`() {
        for (seed in listOf(1000L, 1090L)) checkedMesh("one ulp hole in a large domain", seed)
    }

    @Timeout(10)
    @Test
    fun `pieces that no double divides end the estimate`() {
        for (seed in 60L until 70L) checkedMesh("one ulp profile at an offset", seed)
    }

    @Test
    fun `embedded lines at sharp angles keep every element positive`() {
        for (seed in 0L until 12L) checkedMesh("lines from boundary nodes", seed)
    }

    @Timeout(60)
    @Tag("corpus")
    @Test
    fun `classic closes the front between thousands of holes in time`() {
        val domain = RandomDomains.families.first { it.name == "hundreds of holes" }.make(20)
        val result = MeshGenerator.generate(domain, MeshOptions.builder().strategy(Strategy.CLASSIC).build())
        assertEquals(emptyList<Any>(), MeshCheck.check(result.mesh, domain))
    }

    @Tag("corpus")
    @Test
    fun `a long fine boundary is not taken for a fine domain`() {
        val domain = Domain.of(RandomLoops.ring(200_000))
        val mesh = ConstrainedDelaunay.of(domain)
        val expected = SizeFields.estimateElements(mesh, SizeFields.create(domain, SizeRules(Sizes.GRADE, 1.0, 0.0, Double.POSITIVE_INFINITY, null), mesh))
        assertTrue(expected in 2.0 * 200_000..3.5 * 200_000) { "$expected" }
    }

    @Test
    fun `numbers beyond all measure in a project are refused where they stand`() {
        for (count in listOf("1e9999999999", "2000000000", "9".repeat(100_000))) {
            val text = """{"format": "trigrid", "version": 1, "path": [
                |{"type": "polygon", "firstPoint": [1, 0], "centre": [0, 0], "vertexCount": $count}]}""".trimMargin()
            val error = assertThrows<FileFormatException> { ProjectFile.parse(text, "file") }
            assertEquals(2, error.line)
            assertTrue(error.message!!.length < 600)
        }
    }

    @Test
    fun `well-known text of any depth is refused with its place`() {
        val error = assertThrows<FileFormatException> { WktReader.read("\n" + "GEOMETRYCOLLECTION(".repeat(50_000), "file", "base") }
        assertEquals(2, error.line)
        assertTrue("brackets" in error.message!!)
    }

    @Test
    fun `a given point takes the place of a node that the front has put exactly there`() {
        // A domain of a few units in the last place, where free nodes can hardly lie anywhere else.
        checkedMesh("another with points", 28039)
    }

    private fun checkedMesh(name: String, seed: Long): MeshResult {
        val domain: Domain = RandomDomains.families.first { it.name == name }.make(seed)
        val result = MeshGenerator.generate(domain, FuzzRun.options(seed))
        assertEquals(emptyList<Any>(), MeshCheck.check(result.mesh, domain)) { "$name $seed" }
        return result
    }
}
