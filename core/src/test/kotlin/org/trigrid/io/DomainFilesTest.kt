package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertAll
import org.junit.jupiter.api.assertThrows
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.DomainCheck
import java.nio.file.Path
import kotlin.io.path.readBytes

class DomainFilesTest {
    /** Nodes of each ring, counted by an independent JSON reader. */
    private val rings = mapOf(
        "comb" to listOf(752),
        "general" to listOf(114, 35, 23, 16),
        "hand" to listOf(230),
        "machine_part" to listOf(138, 45, 24),
        "ne50m_croatia_0" to listOf(230),
        "owen" to listOf(77, 16, 50),
        "size_step" to listOf(112),
        "star_1" to listOf(60),
        "zigzag" to listOf(512),
    )

    @Test
    fun `the files of the tests are read whole and are valid`() {
        assertAll(
            rings.map { (name, counts) ->
                {
                    val read = DomainFormats.read(DIRECTORY.resolve("$name.geojson")).single()
                    assertEquals(name, read.name)
                    assertEquals(counts, (0 until read.domain.loopCount).map { read.domain.loopNodes(it).size })
                    assertEquals(counts.sum(), read.domain.nodeCount)
                    assertEquals(counts.indices.map { it > 0 }, counts.indices.map { read.domain.isHole(it) })
                    assertEquals(emptyList<Any>(), DomainCheck.check(read.domain))
                }
            },
        )
    }

    @Test
    fun `a poly file of Triangle`() {
        val frame = DomainFormats.read(DIRECTORY.resolve("frame.poly")).single().domain
        assertEquals(emptyList<Any>(), DomainCheck.check(frame))
        assertEquals(15.0, frame.area)
        assertEquals(2, frame.loopCount)
        assertEquals(listOf(8), (0 until frame.segmentCount).filter { frame.isEmbedded(it) })
        assertEquals(setOf("marker_1", "marker_2", "marker_3"), frame.tags.toSet())
    }

    @Test
    fun `a text is read as its file is`() {
        for (name in listOf("hand.geojson", "general.geojson")) {
            val file = DIRECTORY.resolve(name)
            val read = DomainFormats.read(file).single()
            for (format in listOf(null, DomainFormat.GEOJSON)) {
                val parsed = DomainFormats.parse(file.readBytes(), "some", format, CurveDivision.DEFAULT).single()
                assertEquals(read.name, parsed.name)
                assertArrayEquals(read.domain.nodeCoordinates(), parsed.domain.nodeCoordinates())
            }
        }
        val square = "\uFEFFPOLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
        val division = CurveDivision.DEFAULT.withSpacing(0.25, 1.0)
        val parsed = DomainFormats.parse(square, "a/b: c", DomainFormat.WKT, division).single()
        assertEquals("a/b: c", parsed.name)
        assertEquals(16, parsed.domain.nodeCount)
        val bent = assertThrows<FileFormatException> { DomainFormats.parse("POLYGON ((0 0,\n1 x", "row 7", null, division) }
        assertEquals(listOf("row 7", 2), listOf(bent.source, bent.line))
        assertThrows<FileFormatException> { DomainFormats.parse("neither", "row 8", null, division) }
        assertThrows<FileFormatException> { DomainFormats.parse(byteArrayOf(-1, -2), "row 9", DomainFormat.WKT, division) }
    }

    private companion object {
        /** Maven and Gradle run tests in the module's directory. */
        val DIRECTORY: Path = Path.of("..", "src-test-data", "domains")
    }
}
