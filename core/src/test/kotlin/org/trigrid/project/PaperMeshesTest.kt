package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshReport
import org.trigrid.Sizes
import org.trigrid.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.numbering.NumberingMethod
import java.nio.file.Files
import java.nio.file.Path

/**
 * Meshes of the paper's cases, in both strategies and both kinds of sizes: valid, as good as they were, and about as large as
 * the paper's. `-Dtrigrid.rewrite=true` writes the expected figures anew.
 */
class PaperMeshesTest {
    @Test
    fun `figures are as good as expected`() {
        val expected = Files.readAllLines(expectedFile).drop(1).map { PaperFigures.parse(it) }
        assertEquals(expected.map { it.key }, figures.map { it.key })
        assertEquals(emptyList<String>(), figures.zip(expected).flatMap { (now, was) -> now.faults(was) })
    }

    @Test
    fun `numbers of nodes and elements are about the paper's`() {
        val wrong = ArrayList<String>()
        for ((case, paper) in PAPER_COUNTS) {
            val own = projects.getValue(case).options
            for (made in figures.filter { it.case == case && it.sizes == own.sizes }) {
                // The other strategy need not meet as closely what the look-alikes were made to give.
                val share = if (made.strategy == own.strategy) 0.1 else 0.25
                val fits = Math.abs(made.nodes - paper.first) <= share * paper.first &&
                    Math.abs(made.elements - paper.second) <= share * paper.second
                if (!fits) wrong.add("${made.key}: ${made.nodes} nodes, ${made.elements} elements, the paper has $paper")
            }
        }
        assertEquals(emptyList<String>(), wrong)
    }

    @Test
    fun `the small grid has the paper's numbers and bandwidth`() {
        for (strategy in Strategy.entries) {
            for (numbering in listOf(NumberingMethod.CUTHILL_MCKEE, NumberingMethod.BEST)) {
                val report = mesh("small-grid") { it.strategy(strategy).numbering(numbering) }
                assertEquals(26, report.nodeCount)
                assertEquals(34, report.elementCount)
                assertTrue(report.numberingAfter.bandwidth <= 13, "$strategy $numbering: ${report.numberingAfter}")
            }
        }
    }

    @Test
    fun `the thinner machine part is numbered as well as in the paper`() {
        // The paper's mesh has 87; Cuthill-McKee alone does not reach that on every mesh of this size.
        for ((numbering, limit) in listOf(NumberingMethod.CUTHILL_MCKEE to 100, NumberingMethod.BEST to 87)) {
            val report = mesh("machine-part-thinner") { it.numbering(numbering) }
            assertTrue(report.numberingAfter.bandwidth <= limit, "$numbering: ${report.numberingAfter}")
            assertTrue(report.numberingBefore.bandwidth > 1000)
        }
    }

    private companion object {
        val expectedFile: Path = Path.of("..", "src-test-data", "expected", "paper.csv")
        val projects = PaperProjects.all()

        /** Nodes and elements in the captions and text of the paper. */
        val PAPER_COUNTS = linkedMapOf(
            "small-grid" to (26 to 34),
            "machine-part" to (563 to 966),
            "machine-part-dense" to (1445 to 2585),
            "machine-part-thinner" to (1198 to 2104),
        )

        val figures: List<PaperFigures> by lazy {
            projects.keys.flatMap { case ->
                Strategy.entries.flatMap { strategy ->
                    Sizes.entries.map { sizes -> PaperFigures.of(case, strategy, sizes, mesh(case) { it.strategy(strategy).sizes(sizes) }) }
                }
            }
        }

        /** Meshes with the case's own options but for what [change] does to them; the mesh is proved valid. */
        fun mesh(case: String, change: (MeshOptions.Builder) -> MeshOptions.Builder): MeshReport {
            val project = projects.getValue(case)
            val domain = project.toDomain()
            val result = MeshGenerator.generate(domain, change(project.options.toBuilder()).build())
            assertEquals(emptyList<Any>(), MeshCheck.check(result.mesh, domain), case)
            return result.report
        }

        @BeforeAll
        @JvmStatic
        fun rewriteIfAsked() {
            if (System.getProperty("trigrid.rewrite") != "true") return
            Files.createDirectories(expectedFile.parent)
            Files.writeString(expectedFile, (listOf(PaperFigures.HEADER) + figures.map { it.toLine() }).joinToString("\n", postfix = "\n"))
        }
    }
}
