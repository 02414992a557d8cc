package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

class BenchCommandTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `speed is told by domain and stage`() {
        val outcome = Outcome.of("bench", "--sizes", "100,1e3", "--domains", "square,coast", "--runs", "1", "--warm-up", "0")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        for (name in listOf("square 1e2", "square 1e3", "coast 1e2", "coast 1e3")) {
            assertEquals(2, outcome.out.lines().count { it.startsWith("| $name |") }, outcome.out)
        }
        val columns = outcome.out.lines().first { it.startsWith("| square 1e3 |") }.split("|").map { it.trim() }
        assertEquals(1000.0, columns[3].replace(",", "").toDouble(), 150.0)
        val growth = outcome.out.lines().first { it.startsWith("| coast 1e3 |") }.split("|").map { it.trim() }[8]
        assertTrue(growth.toDouble() > 0)
        assertTrue(outcome.out.startsWith("`trigrid bench --sizes 100,1e3 "), outcome.out)
    }

    @Test
    fun `quality of a folder of domains goes between the marks of a document`() {
        val domains = Files.createDirectory(folder.resolve("domains"))
        domains.resolve("unit.wkt").writeText("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
        domains.resolve("README.md").writeText("not a domain")
        val document = folder.resolve("quality.md")
        document.writeText("# Quality\n\n<!-- measured: begin -->\nold\n<!-- measured: end -->\n\nWhy.\n")
        val outcome = Outcome.of("bench", "--quality", domains, "--markdown", document)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals("", outcome.out)
        val text = document.readText()
        assertTrue(text.startsWith("# Quality\n\n<!-- measured: begin -->"), text)
        assertTrue(text.endsWith("<!-- measured: end -->\n\nWhy.\n"), text)
        // Two right-angled triangles: q = sqrt(3) / 2, and their common edge sqrt(2) times as long as wanted.
        assertTrue("| unit | 2 | 0.866 | 0.866 | 0.8660 | 45.0 | 45.0 | 90.0 | – | 0.500 |" in text, text)
        assertTrue("old" !in text)
    }

    @ParameterizedTest
    @ValueSource(strings = ["--runs=0", "--sizes=0", "--sizes=1e9", "--sizes=many", "--domains=torus"])
    fun `values out of range are usage errors`(option: String) {
        val outcome = Outcome.of("bench", option)
        assertEquals(ExitCodes.USAGE, outcome.code)
        assertEquals("", outcome.out)
    }

    @Test
    fun `a domain file that is missing is told by its name`() {
        val outcome = Outcome.of("bench", "--quality", folder.resolve("none.wkt"))
        assertEquals(ExitCodes.FILE_TROUBLE, outcome.code)
        assertTrue("none.wkt" in outcome.err, outcome.err)
    }
}
