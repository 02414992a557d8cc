package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.io.MeshFormats
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** What becomes of meshes of six-node elements that are read. */
class SecondOrderCommandsTest {
    @TempDir
    lateinit var folder: Path

    private val curved: Path get() = folder.resolve("bastian.msh")

    private fun done(vararg arguments: Any): String {
        val outcome = Outcome.of(*arguments)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        return outcome.out
    }

    private fun refused(code: Int, word: String, vararg arguments: Any) {
        val outcome = Outcome.of(*arguments)
        assertEquals(code, outcome.code, outcome.err)
        assertTrue(word in outcome.err, outcome.err)
    }

    @BeforeEach
    fun mesh() {
        done("mesh", Path.of("..", "src-test-data", "paper", "bastian.trigrid.json"), "-o", curved, "--order", "2")
    }

    @Test
    fun `they stay so in other formats, or become their corners`() {
        val there = folder.resolve("a.vtu")
        done("convert", curved, there)
        val back = folder.resolve("back.msh")
        done("convert", there, back)
        val first = MeshFormats.readEither(curved).quadratic!!
        val last = MeshFormats.readEither(back).quadratic!!
        assertArrayEquals(first.nodeCoordinates(), last.nodeCoordinates())
        assertArrayEquals(first.elementNodes(), last.elementNodes())
        for (tag in first.tags) assertArrayEquals(first.nodesOn(tag), last.nodesOn(tag))
        val linear = folder.resolve("linear.su2")
        refused(ExitCodes.USAGE, "--order 1", "convert", curved, linear)
        done("convert", curved, linear, "--order", "1")
        refused(ExitCodes.USAGE, "--project", "convert", curved, there, "--order", "2", "--project", "x.trigrid.json")
        val corners = folder.resolve("corners.msh")
        done("convert", curved, corners, "--order", "1")
        val read = MeshFormats.readEither(curved)
        assertArrayEquals(read.corners.nodeCoordinates(), MeshFormats.read(corners).nodeCoordinates())
        done("convert", curved, folder.resolve("outline.geojson"))
        done("picture", curved, "-o", folder.resolve("mesh.svg"))
    }

    @Test
    fun `info tells of them, and which are folded`() {
        val out = done("info", curved)
        assertTrue(Regex("nodes: +\\d+, six an element, \\d+ of them corners").containsMatchIn(out), out)
        val mesh = MeshFormats.readEither(curved).quadratic!!
        val middle = mesh.nodeOf(7, 3)
        val corner = mesh.nodeOf(7, 2)
        val lines = curved.readText().lines().toMutableList()
        // The middle of an edge at the corner across.
        val at = lines.indexOf("\$Nodes") + 2 + middle
        lines[at] = "${middle + 1} ${mesh.x(corner)} ${mesh.y(corner)} 0"
        val bent = folder.resolve("bent.msh").also { it.writeText(lines.joinToString("\n")) }
        refused(ExitCodes.INVALID_DOMAIN, "FOLDED at (", "info", bent)
    }

    @Test
    fun `they are renumbered, but not improved or refined`() {
        val target = folder.resolve("new.msh")
        val out = done("renumber", curved, "-o", target)
        assertTrue("bandwidth" in out)
        assertEquals(MeshFormats.readEither(curved).quadratic!!.nodeCount, MeshFormats.readEither(target).quadratic!!.nodeCount)
        refused(ExitCodes.USAGE, "six nodes", "renumber", curved, "-o", folder.resolve("new.su2"))
        for (command in listOf("improve", "refine")) refused(ExitCodes.FILE_TROUBLE, "--order 1", command, curved, "-o", target)
        refused(ExitCodes.USAGE, "trigrid info", "check", curved)
    }
}
