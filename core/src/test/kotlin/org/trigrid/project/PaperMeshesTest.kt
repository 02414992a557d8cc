package org.trigrid.project

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshReport
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshCheck
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.Sizes
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
                val fits = Math.abs(made.nodes - paper.first) <= 0.1 * paper.first &&
                    Math.abs(made.elements - paper.second) <= 0.1 * paper.second
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
        // The paper's mesh has 87. Its rule starts at the few corners of lowest degree; how well these lie is luck.
        for (strategy in Strategy.entries) {
            val best = mesh("machine-part-thinner") { it.numbering(NumberingMethod.BEST).strategy(strategy) }
            assertTrue(best.numberingAfter.bandwidth <= 89, "$strategy: ${best.numberingAfter}")
            val rule = mesh("machine-part-thinner") { it.numbering(NumberingMethod.CUTHILL_MCKEE).strategy(strategy) }
            assertTrue(10 * rule.numberingAfter.bandwidth < rule.numberingBefore.bandwidth, "$strategy: ${rule.numberingAfter}")
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
