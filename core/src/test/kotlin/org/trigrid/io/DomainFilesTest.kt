package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertAll
import org.trigrid.domain.DomainCheck
import java.nio.file.Path

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

    private companion object {
        /** Maven and Gradle run tests in the module's directory. */
        val DIRECTORY: Path = Path.of("..", "src-test-data", "domains")
    }
}
