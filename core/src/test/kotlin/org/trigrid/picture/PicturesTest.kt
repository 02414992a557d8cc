package org.trigrid.picture

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.domain.Domain
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.w3c.dom.Document
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory

class PicturesTest {
    @TempDir
    lateinit var folder: Path

    private val ring = GridMeshes.shaken(9, 6, 3L) { i, j -> i in 3..5 && j in 2..3 }

    private fun svg(picture: Picture): Document {
        val file = folder.resolve("picture.svg")
        picture.writeSvg(file)
        return Files.newInputStream(file).use { DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(it) }
    }

    private fun Document.texts(): List<String> {
        val nodes = getElementsByTagName("text")
        return List(nodes.length) { nodes.item(it).textContent }
    }

    @Test
    fun `a PNG has the size asked for, holes are white and elements are not`() {
        for (quality in listOf(false, true)) {
            val picture = Pictures.mesh(ring.mesh, PictureOptions.builder().quality(quality).build())
            val file = folder.resolve("ring.png")
            picture.writePng(file, 700)
            val image = ImageIO.read(file.toFile())
            assertEquals(700, maxOf(image.width, image.height))
            val scale = 700 / maxOf(picture.width, picture.height)
            fun at(x: Double, y: Double): Int {
                val unit = 1000.0 / 9
                return image.getRGB(((30 + x * unit) * scale).toInt(), ((30 + (6 - y) * unit) * scale).toInt()) and 0xFFFFFF
            }
            assertEquals(0xFFFFFF, at(4.5, 3.0))
            assertNotEquals(0xFFFFFF, at(0.4, 0.2))
        }
    }

    @Test
    fun `an SVG shows every node and number that fits, and is the same each time`() {
        val options = PictureOptions.builder().nodeNumbers(true).elementNumbers(true).build()
        val document = svg(Pictures.mesh(ring.mesh, options))
        assertEquals(ring.mesh.nodeCount, document.getElementsByTagName("circle").length)
        val texts = document.texts()
        assertTrue((1..ring.mesh.nodeCount).all { it.toString() in texts })
        assertTrue(texts.size > ring.mesh.nodeCount + ring.mesh.elementCount / 2)
        val first = Files.readString(folder.resolve("picture.svg"))
        Pictures.mesh(ring.mesh, options).writeSvg(folder.resolve("again.svg"))
        assertEquals(first, Files.readString(folder.resolve("again.svg")))
        val from0 = svg(Pictures.mesh(ring.mesh, PictureOptions.builder().nodeNumbers(true).firstNumber(0).build())).texts()
        assertTrue("0" in from0 && ring.mesh.nodeCount.toString() !in from0)
    }

    @Test
    fun `labels that would cover each other are left out`() {
        val dense = GridMeshes.shaken(60, 60, 1L).mesh
        val texts = svg(Pictures.mesh(dense, PictureOptions.builder().nodeNumbers(true).size(300).build())).texts()
        assertTrue(texts.size < dense.nodeCount / 4, "${texts.size}")
        val layout = LabelLayout(100.0, 100.0, 10.0)
        assertTrue(layout.take(10.0, 10.0, 30.0, 20.0))
        assertTrue(!layout.take(29.0, 19.0, 40.0, 30.0))
        assertTrue(layout.take(30.0, 10.0, 40.0, 20.0))
        assertTrue(!layout.take(90.0, 50.0, 110.0, 60.0))
        layout.blockLine(0.0, 50.0, 80.0, 50.0)
        assertTrue(!layout.take(20.0, 45.0, 40.0, 55.0))
    }

    @Test
    fun `a quality legend adds up`() {
        val shares = svg(Pictures.mesh(ring.mesh, PictureOptions.builder().quality(true).build())).texts()
            .filter { it.endsWith("%") }.map { it.removeSuffix(" %").toDouble() }
        assertEquals(Palette.qualityColours.size, shares.size)
        assertEquals(100.0, shares.sum(), 0.5)
    }

    @Test
    fun `a domain is drawn with its groups, whatever they are called`() {
        val d = ring.domain
        val odd = Domain(d.xy, d.segments, d.segmentTags, d.embedded, listOf("<&\"'> Träger", "b"), "plate")
        val document = svg(Pictures.domain(odd, PictureOptions.builder().nodeNumbers(true).build()))
        assertEquals(d.nodeCount, document.getElementsByTagName("circle").length)
        assertTrue("<&\"'> Träger" in document.texts())
    }

    @Test
    fun `groups have the colours that are chosen for them`() {
        val domain = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0), "rim")
            .hole(doubleArrayOf(0.6, 0.2, 0.8, 0.2, 0.8, 0.4), "hole").build()
        val options = PictureOptions.builder().groupColours(mapOf("hole" to 0x12ab34, "unused" to 0)).build()
        val file = folder.resolve("groups.svg")
        Pictures.domain(domain, options).writeSvg(file)
        assertTrue("#12ab34" in Files.readString(file).lowercase())
        Pictures.domain(domain).writeSvg(file)
        assertTrue("#12ab34" !in Files.readString(file).lowercase())
        assertThrows(IllegalArgumentException::class.java) { PictureOptions.builder().groupColours(mapOf("hole" to -1)) }
    }

    @Test
    fun `faulty and empty things are drawn as far as they go`() {
        val open = Domain(
            doubleArrayOf(0.0, 0.0, 1.0, Double.NaN, 1.0, 1.0, 0.0, 0.0), intArrayOf(0, 1, 1, 2, 2, 3), IntArray(3), BooleanArray(3),
            listOf("a"), "r",
        )
        val texts = svg(Pictures.domain(open, PictureOptions.builder().nodeNumbers(true).build())).texts()
        assertTrue("3" in texts && "2" !in texts, "$texts")
        Pictures.domain(open).toImage(100)
        val empty = TriMesh.of(DoubleArray(0), IntArray(0))
        svg(Pictures.mesh(empty, PictureOptions.builder().quality(true).nodeNumbers(true).build()))
        svg(Pictures.matrix(empty))
        assertThrows(IllegalArgumentException::class.java) { Pictures.mesh(ring.mesh).toImage(1) }
        assertThrows(IllegalArgumentException::class.java) { PictureOptions.builder().size(1) }
    }

    @Test
    fun `a matrix picture tells bandwidth and profile before and after`() {
        val after = Numbering.renumber(ring.mesh, NumberingMethod.BEST)
        val texts = svg(Pictures.matrix(ring.mesh, after)).texts()
        for (mesh in listOf(ring.mesh, after)) {
            val metrics = Numbering.metrics(mesh)
            val profile = QualityLegend.grouped(metrics.profile)
            assertTrue("bandwidth ${metrics.bandwidth}    profile $profile" in texts, "$texts")
        }
        assertEquals("1 234 567", QualityLegend.grouped(1234567))
        // Every entry of a small matrix is a box of its own.
        val boxes = folder.resolve("picture.svg").let { Files.readString(it) }.split("shape-rendering")[1].substringBefore("/>")
        assertEquals(ring.mesh.nodeCount + 2 * ring.mesh.edgeCount, boxes.count { it == 'M' })
    }
}
