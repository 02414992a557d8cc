package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

class UsageTest {
    @Test
    fun `help lists the commands with examples and ends well`() {
        val outcome = Outcome.of("--help")
        assertEquals(ExitCodes.DONE, outcome.code)
        assertEquals("", outcome.err)
        for (word in listOf("mesh", "check", "info", "picture", "convert", "renumber", "improve", "refine", "bench", "edit", "completion", "man", "Examples:", "Exit codes:")) {
            assertTrue(word in outcome.out, "$word in ${outcome.out}")
        }
    }

    @ParameterizedTest
    @ValueSource(
        strings = [
            "mesh", "check", "info", "picture", "convert", "renumber", "improve", "refine", "bench", "edit", "completion", "man",
        ],
    )
    fun `each command has help with an example`(command: String) {
        val outcome = Outcome.of(command, "--help")
        assertEquals(ExitCodes.DONE, outcome.code)
        assertTrue("Usage: trigrid $command" in outcome.out, outcome.out)
        assertTrue("  trigrid $command " in outcome.out, outcome.out)
    }

    @Test
    fun `the help of mesh names every option of the manual`() {
        val help = Outcome.of("mesh", "--help").out
        val options = listOf(
            "--output", "--format", "--spacing", "--ratio", "--keep-connectors", "--sizes", "--gradation", "--min-size",
            "--max-size", "--strategy", "--max-elements", "--no-improve", "--no-renumber", "--report", "--picture", "--join", "--unit",
            "--out-dir", "--jobs", "--resume", "--order", "--size-source",
        )
        for (option in options) assertTrue(option in help, option)
    }

    @Test
    fun `no command is a usage error that says what there is`() {
        val outcome = Outcome.of()
        assertEquals(ExitCodes.USAGE, outcome.code)
        assertEquals("", outcome.out)
        assertEquals(
            listOf("trigrid: say what to do: mesh, check, info, picture, convert, renumber, improve, refine or edit", "Try 'trigrid --help'."),
            outcome.errorLines,
        )
    }

    @Test
    fun `an unknown option is a usage error of its command`() {
        val outcome = Outcome.of("mesh", "in.wkt", "-o", "out.msh", "--sise", "3")
        assertEquals(ExitCodes.USAGE, outcome.code)
        assertTrue(outcome.errorLines.first().startsWith("trigrid: Unknown option"), outcome.err)
        assertEquals("Try 'trigrid mesh --help'.", outcome.errorLines.last())
    }

    @Test
    fun `an output is required`() {
        val outcome = Outcome.of("mesh", "in.wkt")
        assertEquals(ExitCodes.USAGE, outcome.code)
        assertTrue("--output" in outcome.err, outcome.err)
    }

    @ParameterizedTest
    @ValueSource(
        strings = [
            "--spacing=0", "--spacing=NaN", "--spacing=x", "--ratio=2", "--gradation=-1", "--size-source=0.1", "--size-source=0.1@1", "--size-source=0@1,1", "--size-source=0.1@1,x", "--region=a", "--region=@1,1", "--region=a,0@1,1", "--region=a=x@1,1", "--point=1", "--line=1,2", "--line=a,0@1,2,3,4", "--min-size=-1", "--max-size=0",
            "--strategy=best", "--sizes=none", "--format=3.0", "--picture=mesh.gif", "--unit=ell", "--join=-1",
        ],
    )
    fun `values out of range are usage errors before anything is written`(option: String) {
        val folder = java.nio.file.Files.createTempDirectory("trigrid-usage")
        val input = java.nio.file.Files.writeString(folder.resolve("in.wkt"), "POLYGON ((0 0, 1 0, 1 1, 0 0))")
        val outcome = Outcome.of("mesh", input, "-o", folder.resolve("out.msh"), option)
        assertEquals(ExitCodes.USAGE, outcome.code, outcome.err)
        assertTrue(outcome.errorLines.first().startsWith("trigrid: "), outcome.err)
        assertEquals(listOf("in.wkt"), folder.toFile().list()!!.toList())
    }

    @Test
    fun `version names the program`() {
        val outcome = Outcome.of("--version")
        assertEquals(ExitCodes.DONE, outcome.code)
        assertTrue(outcome.out.startsWith("trigrid "), outcome.out)
    }
}
