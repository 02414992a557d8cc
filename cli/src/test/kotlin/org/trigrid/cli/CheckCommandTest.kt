package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class CheckCommandTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `a good domain is told in one line`() {
        val outcome = Outcome.of("check", Samples.lake)
        assertEquals(ExitCodes.DONE, outcome.code)
        assertEquals("${Samples.lake}: lake: 229 nodes, 5 loops, no faults", outcome.out.trimEnd())
    }

    @Test
    fun `every fault has its line with kind, place and nodes`() {
        val input = Samples.file(
            folder, "faulty.wkt",
            "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0), (10 10, 11 10, 11 11, 10 10))",
        )
        val outcome = Outcome.of("check", input)
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertEquals("", outcome.out)
        val form = Regex(Regex.escape(input.toString()) + """: [A-Z_]+ at \(\S+, \S+\)(, nodes?( \d+)+)?: .+""")
        for (line in outcome.errorLines) assertTrue(form.matches(line), line)
        assertTrue(outcome.errorLines.any { ": CROSSING at (1.0, 1.0), nodes " in it }, outcome.err)
        assertTrue(outcome.errorLines.size >= 2, outcome.err)
    }

    @Test
    fun `what costs quality is a warning and no fault`() {
        val input = Samples.file(folder, "sharp.wkt", "POLYGON ((0 0, 10 0, 10 0.2, 0 0))")
        val outcome = Outcome.of("check", input)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertTrue(outcome.errorLines.any { it.startsWith("$input: warning: SHARP_ANGLE at (0.0, 0.0), node") }, outcome.err)
    }

    @Test
    fun `a spacing is laid on the edges before the check`() {
        val outcome = Outcome.of("check", Samples.plate(folder), "--spacing", "0.1")
        assertTrue(": 68 nodes, 2 loops" in outcome.out, outcome.out)
    }
}
