package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText

class PictureCommandTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest
    @ValueSource(strings = ["mesh", "domain", "numbers", "quality", "matrix"])
    fun `a domain is drawn in every way`(content: String) {
        val file = folder.resolve("$content.svg")
        val outcome = Outcome.of("picture", Samples.plate(folder), "-o", file, "--show", content, "--spacing", "0.2")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals("", outcome.out + outcome.err)
        assertTrue("<svg" in file.readText())
    }

    @Test
    fun `the matrix of a domain is drawn before and after renumbering`() {
        val file = folder.resolve("matrix.svg")
        Outcome.of("picture", Samples.plate(folder), "-o", file, "--show", "matrix", "--spacing", "0.2")
        assertTrue("Before renumbering" in file.readText() && "After renumbering" in file.readText())
    }

    @Test
    fun `a mesh file is drawn as it is, a png in the size asked for`() {
        val mesh = folder.resolve("plate.msh")
        Outcome.of("mesh", Samples.plate(folder), "-o", mesh, "--spacing", "0.2")
        val file = folder.resolve("plate.png")
        val outcome = Outcome.of("picture", mesh, "-o", file, "--show", "quality", "--pixels", "400")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        val image = ImageIO.read(file.toFile())
        assertEquals(400, maxOf(image.width, image.height))
    }

    @Test
    fun `several polygons make several pictures`() {
        Outcome.of("picture", Samples.twoSquares(folder), "-o", folder.resolve("p.svg"), "--show", "domain")
        assertEquals(listOf("p-1.svg", "p-2.svg", "two.wkt"), folder.listDirectoryEntries().map { it.name }.sorted())
    }

    @Test
    fun `a faulty domain can be drawn, its mesh not`() {
        val input = Samples.bowTie(folder)
        assertEquals(ExitCodes.DONE, Outcome.of("picture", input, "-o", folder.resolve("d.svg"), "--show", "domain").code)
        assertEquals(ExitCodes.INVALID_DOMAIN, Outcome.of("picture", input, "-o", folder.resolve("m.svg")).code)
    }

    @Test
    fun `a mesh file has no domain to draw`() {
        val outcome = Outcome.of("picture", folder.resolve("a.msh"), "-o", folder.resolve("a.svg"), "--show", "domain")
        assertEquals(ExitCodes.USAGE, outcome.code)
    }
}
