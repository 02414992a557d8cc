package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.EnabledIf
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.isWritable
import kotlin.io.path.readBytes

/** What users get wrong, and what goes wrong around them: a message that names the file and the matter, and the right exit code. */
class HostileUseTest {
    @TempDir
    lateinit var folder: Path

    private val plate: Path by lazy { Samples.plate(folder) }

    /** One line, or two for usage, and no trace of a defect. */
    private fun refused(code: Int, message: String, vararg arguments: Any) {
        val outcome = Outcome.of(*arguments)
        assertEquals(code, outcome.code, outcome.err)
        assertTrue(message in outcome.err, outcome.err)
        assertEquals(if (code == ExitCodes.USAGE) 2 else 1, outcome.errorLines.size, outcome.err)
    }

    @Test
    fun `inputs are not written over`() {
        val before = plate.readBytes()
        val out = folder.resolve("x.msh")
        refused(ExitCodes.USAGE, "is the mesh, but is the input", "mesh", plate, "-o", plate, "--format", "msh22")
        refused(ExitCodes.USAGE, "is the report, but is the input", "mesh", plate, "-o", out, "--report", folder.resolve("./plate.wkt"))
        refused(ExitCodes.USAGE, "is the report, but is the mesh", "mesh", plate, "-o", out, "--report", out)
        refused(ExitCodes.USAGE, "is the report, but is an input", "mesh", plate, "--out-dir", folder.resolve("d"), "--report", plate)
        val drawing = Samples.file(folder, "d.svg", "<svg><path d='M0 0 H1 V1 Z'/></svg>")
        refused(ExitCodes.USAGE, "is the picture, but is the input", "picture", drawing, "-o", drawing)
        assertArrayEquals(before, plate.readBytes())
        assertFalse(Files.exists(out))
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    fun `not by a link either, and folders behind links are read`() {
        val link = Files.createSymbolicLink(folder.resolve("link.msh"), plate)
        refused(ExitCodes.USAGE, "is the mesh, but is the input", "mesh", plate, "-o", link)
        val outlines = folder.resolve("outlines").createDirectories()
        Samples.plate(outlines)
        Files.createSymbolicLink(outlines.resolve("self"), outlines)
        val behind = Files.createSymbolicLink(folder.resolve("behind"), outlines)
        val outcome = Outcome.of("mesh", behind, "--out-dir", folder.resolve("meshes"))
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertTrue("1 meshes of 1 files" in outcome.out, outcome.out)
        Files.createSymbolicLink(folder.resolve("round.wkt"), Path.of("round.wkt"))
        refused(ExitCodes.FILE_TROUBLE, "round.wkt: ", "mesh", folder.resolve("round.wkt"), "-o", folder.resolve("x.msh"))
    }

    @Test
    fun `a batch that writes where its inputs are spares them`() {
        val frame = folder.resolve("frame.poly")
        Files.copy(Path.of("..", "src-test-data", "domains", "frame.poly"), frame)
        val before = frame.readBytes()
        val outcome = Outcome.of("mesh", frame, "--out-dir", folder, "--format", "triangle")
        assertEquals(ExitCodes.FILE_TROUBLE, outcome.code)
        assertTrue("frame.poly: an input" in outcome.err, outcome.err)
        assertArrayEquals(before, frame.readBytes())
    }

    @Test
    fun `folders and empty names are no files`() {
        val out = folder.resolve("x.msh")
        for (command in listOf("check", "info")) refused(ExitCodes.FILE_TROUBLE, "$folder: a folder, not a file", command, folder)
        refused(ExitCodes.USAGE, "with --out-dir", "mesh", folder, "-o", out)
        refused(ExitCodes.FILE_TROUBLE, "$folder: a folder, not a file", "mesh", plate, "-o", folder)
        refused(ExitCodes.FILE_TROUBLE, "an empty name", "mesh", plate, "-o", "")
        refused(ExitCodes.FILE_TROUBLE, "an empty name", "check", "")
        refused(ExitCodes.USAGE, "an empty name", "mesh", "", "--out-dir", folder.resolve("d"))
        refused(ExitCodes.USAGE, "an empty name", "mesh", plate, "--out-dir", "")
        refused(ExitCodes.USAGE, "standard output", "mesh", plate, "-o", "-")
        refused(ExitCodes.FILE_TROUBLE, "not a folder", "mesh", plate, "-o", plate.resolve("x.msh"))
        refused(ExitCodes.FILE_TROUBLE, "of domains, not of a mesh", "info", plate)
    }

    @Test
    fun `commands, arguments and patterns that make no sense`() {
        refused(ExitCodes.USAGE, "no command 'mash'; there are help, mesh", "mash")
        refused(ExitCodes.USAGE, "nothing to do with 'more'", "man", "more")
        refused(ExitCodes.FILE_TROUBLE, "zz*", "mesh", "$folder/zz*", "--out-dir", folder.resolve("d"))
        refused(ExitCodes.USAGE, "makes no sense", "mesh", "$folder/{a", "--out-dir", folder.resolve("d"))
        refused(ExitCodes.USAGE, "at least 1.0E-60", "mesh", plate, "-o", folder.resolve("x.msh"), "--size-source", "1e-320@0,0")
    }

    @Test
    fun `names may hold nearly anything`() {
        for (name in listOf("a b.wkt", "ünïcode 漢.wkt", "@at.wkt", "-dash.wkt", "semi;colon\$HOME.wkt")) {
            val input = Samples.file(folder, name, "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
            val output = folder.resolve(name.replace("wkt", "msh"))
            val outcome = Outcome.of("mesh", input, "-o", output)
            assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
            assertTrue(Files.exists(output))
        }
    }

    private fun hasFullDevice() = FULL.isWritable()

    @Test
    @EnabledIf("hasFullDevice")
    fun `a full disk is told with the file`() {
        refused(ExitCodes.FILE_TROUBLE, "$FULL: No space left", "mesh", plate, "-o", FULL)
        refused(ExitCodes.FILE_TROUBLE, "$FULL: No space left", "mesh", plate, "-o", folder.resolve("x.msh"), "--report", FULL)
        refused(ExitCodes.FILE_TROUBLE, "$FULL: No space left", "mesh", plate, "--out-dir", folder.resolve("d"), "--report", FULL)
    }

    @Test
    fun `a folder that may not be written is told before the work`() {
        val locked = folder.resolve("locked").createDirectories()
        assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked))
        refused(ExitCodes.FILE_TROUBLE, "$locked: access denied", "mesh", plate, "-o", locked.resolve("x.msh"))
    }

    private fun codeWithOutput(reason: String): Pair<Int, String> {
        val failing = object : OutputStream() {
            override fun write(byte: Int) = throw IOException(reason)
        }
        val watched = WatchedOutput(failing)
        val err = ByteArrayOutputStream()
        val terminal = Terminal(PrintStream(watched.buffered()), PrintStream(err), false, watched)
        return run(arrayOf("man"), terminal, Cancellation()) to err.toString()
    }

    @Test
    fun `output that is lost is told, but not that a reader has had enough`() {
        assertEquals(ExitCodes.FILE_TROUBLE to "standard output: No space left on device\n", codeWithOutput("No space left on device").let { (code, err) -> code to err.replace("\r", "") })
        assertEquals(ExitCodes.DONE to "", codeWithOutput("Broken pipe"))
    }

    private companion object {
        val FULL: Path = Path.of("/dev/full")
    }
}
