package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** What the command line gives the shell and `man`. */
class ShellCommandsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `bash completes commands and options`() {
        val script = Outcome.of("completion", "bash").out
        val file = Files.writeString(folder.resolve("trigrid.bash"), script)
        assumeTrue(Files.exists(Path.of("/bin/bash")))
        val words = "COMP_WORDS=(trigrid mesh --spa); COMP_CWORD=2; _complete_trigrid; echo \"\${COMPREPLY[@]}\""
        assertEquals("--spacing", output("/bin/bash", "--norc", "-c", "source $file; compopt() { :; }; $words"))
        val commands = "COMP_WORDS=(trigrid re); COMP_CWORD=1; _complete_trigrid; echo \"\${COMPREPLY[@]}\""
        assertEquals(setOf("renumber", "refine"), output("/bin/bash", "--norc", "-c", "source $file; compopt() { :; }; $commands").split(' ').toSet())
    }

    @Test
    fun `zsh and fish have their scripts`() {
        assertTrue("bashcompinit" in Outcome.of("completion", "zsh").out)
        val fish = Outcome.of("completion", "fish").out.lines()
        assertTrue(fish.any { it.startsWith("complete -c trigrid -n __fish_use_subcommand -f -a mesh -d 'Mesh a domain") })
        assertTrue(fish.any { "__fish_seen_subcommand_from mesh\" -l sizes -x -a 'smooth grade' -d " in it })
        assertTrue(fish.any { "__fish_seen_subcommand_from refine\" -l times -r -d " in it })
        assertEquals(ExitCodes.USAGE, Outcome.of("completion", "tcsh").code)
    }

    @Test
    fun `the manual page names every command and option, and groff has no complaint`() {
        val page = Outcome.of("man").out
        assertTrue(page.startsWith(".TH TRIGRID 1"))
        for (word in listOf(".SS trigrid mesh", "\\-\\-spacing=S", ".SS trigrid convert", ".SH EXIT STATUS")) assertTrue(word in page, word)
        assumeTrue(Files.exists(Path.of("/usr/bin/groff")))
        val file = Files.writeString(folder.resolve("trigrid.1"), page)
        assertEquals("", output("/usr/bin/groff", "-man", "-Tutf8", "-ww", "-z", file.toString()))
    }

    private fun output(vararg command: String): String {
        val process = ProcessBuilder(*command).redirectErrorStream(true).start()
        val text = process.inputStream.readAllBytes().toString(Charsets.UTF_8).trim()
        assertTrue(process.waitFor(20, TimeUnit.SECONDS))
        return text
    }
}
