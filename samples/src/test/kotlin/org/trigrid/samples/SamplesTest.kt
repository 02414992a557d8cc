package org.trigrid.samples

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshRework
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.project.ProjectFile
import org.trigrid.project.ShapeMiddles
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readLines
import kotlin.io.path.walk

/** The samples run, and find what is known of their problems. */
class SamplesTest {
    private val paper = Path.of("../src-test-data/paper")

    @Test
    fun `the error of Poisson's equation falls at second order`() {
        val coarse = MeshGenerator.generate(ProjectFile.read(paper.resolve("hand.trigrid.json")).toDomain()).mesh
        val fine = Numbering.renumber(MeshRework.refine(coarse), NumberingMethod.BEST)
        val before = PoissonOnHand.error(coarse, PoissonOnHand.solve(coarse).u)
        val after = PoissonOnHand.error(fine, PoissonOnHand.solve(fine).u)
        assertTrue(before < 0.06, "error $before")
        assertEquals(2.0, Math.log(before / after) / Math.log(2.0), 0.1)
    }

    @Test
    fun `renumbering saves the solver memory, and changes no solution`() {
        val hand = ProjectFile.read(paper.resolve("hand.trigrid.json")).toDomain().respaced(0.2, 1.0)
        val unsorted = MeshGenerator.generate(hand, MeshOptions.builder().numbering(NumberingMethod.NONE).build()).mesh
        val sorted = Numbering.renumber(unsorted, NumberingMethod.BEST)
        val a = PoissonOnHand.solve(unsorted)
        val b = PoissonOnHand.solve(sorted)
        assertEquals(PoissonOnHand.error(unsorted, a.u), PoissonOnHand.error(sorted, b.u), 1e-12)
        assertTrue(sorted.bandwidth * 5 < unsorted.bandwidth)
        assertTrue(b.factorEntries * 3L < a.factorEntries, "${b.factorEntries} of ${a.factorEntries}")
    }

    @Test
    fun `the stress at the hole is about three times that of the pull`() {
        val mesh = PlateWithHole.mesh(0.02)
        val u = PlateWithHole.displacements(mesh)
        val stress = PlateWithHole.stressAtTop(mesh, u)
        assertEquals(3.03, stress, 0.1)
        // A strip without a hole would grow by 20 a half-length of 20; one with a small hole grows a little more.
        val growth = mesh.nodesOn("right").map { u[2 * it] }.average()
        assertTrue(growth in 20.0..20.5, "growth $growth")
    }

    @Test
    fun `the heat that enters the machine part leaves it`() {
        val project = ProjectFile.read(paper.resolve("machine-part.trigrid.json"))
        val coarse = MeshGenerator.generate(project.toDomain(), project.options).mesh
        val fine = MeshRework.refine(coarse, ShapeMiddles(project.path))
        val heats = listOf(coarse, fine).map { HeatInMachinePart.solve(it) }
        for (heat in heats) {
            assertEquals(heat.entering, heat.leaving, 1e-9 * heat.leaving)
            assertTrue(heat.temperature.min() > 20 && heat.temperature.max() <= 90 + 1e-9)
        }
        assertEquals(heats[1].entering, heats[0].entering, 0.01 * heats[1].entering)
    }

    @Test
    fun `the coil's heat passes the insulation and leaves the iron`() {
        val mesh = MeshGenerator.generate(CoilInIron.domain()).mesh
        val temperature = CoilInIron.temperature(mesh)
        val made = 0.5 * 1.6 * 1.6
        assertEquals(made, CoilInIron.heatOut(mesh, temperature, "outside", "iron"), 0.03 * made)
        // In a thin layer of insulation round the coil the temperature falls by heat * thickness / (conductivity * length).
        val drop = mesh.nodesOn("coil").map { temperature[it] }.average() - mesh.nodesOn("slot").map { temperature[it] }.average()
        assertEquals(made * 0.2 / (0.002 * 4 * 1.8), drop, 0.1 * drop)
        assertTrue(temperature[mesh.nodesOn("thermometer").single()] in 0.05..0.5)
    }

    @Test
    fun `each program prints its figures`() {
        val poisson = printed { PoissonOnHand.main(arrayOf("$paper/hand.trigrid.json")) }
        assertTrue(Regex("""\n +13\d{3} .* 2\.\d\d\n""").containsMatchIn(poisson), poisson)
        assertTrue(Regex("""\nrenumbered +\d+ +\d+ """).containsMatchIn(poisson), poisson)
        assertTrue(Regex("""\n +0\.010 +\d+ +[23]\.\d{3}\n""").containsMatchIn(printed { PlateWithHole.main(emptyArray()) }))
        val heat = printed { HeatInMachinePart.main(arrayOf("$paper/machine-part.trigrid.json")) }
        assertEquals(4, heat.trim().lines().size, heat)
        val coil = printed { CoilInIron.main(emptyArray()) }
        assertTrue(Regex("""copper +material 3, +\d+ elements\nhottest 1\d\.\d\d K, at the thermometer 0\.\d\d K""").containsMatchIn(coil), coil)
    }

    @Test
    fun `the page on embedding shows lines of the samples`() {
        val sources = Path.of("src/main").walk().filter { it.extension in setOf("java", "kt") }
            .flatMap { it.readLines() }.map { it.trim() }.toSet()
        val shown = ArrayList<String>()
        var isInside = false
        for (line in Path.of("../docs/embedding.md").readLines()) {
            if (isInside && !line.startsWith("```")) shown.add(line.trim())
            if (line.startsWith("```")) isInside = !isInside
        }
        assertTrue(shown.size >= 12, "$shown")
        assertEquals(emptyList<String>(), shown.filter { it !in sources })
    }

    private fun printed(program: () -> Unit): String {
        val bytes = ByteArrayOutputStream()
        val out = System.out
        System.setOut(PrintStream(bytes, true, Charsets.UTF_8))
        try {
            program()
        } finally {
            System.setOut(out)
        }
        return bytes.toString(Charsets.UTF_8).replace("\r\n", "\n")
    }
}
