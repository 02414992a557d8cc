package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

class DomainFormatsTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `the text decides where the extension says nothing`() {
        assertEquals(3, nodes("a.txt", "\n POLYGON ((0 0, 1 0, 0 1, 0 0))"))
        assertEquals(3, nodes("b", "\uFEFF{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1]]]}"))
        assertEquals(3, nodes("c.in", "# triangle\n3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"))
        assertEquals(3, nodes("D.GeoJSON", "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1]]]}"))
    }

    @Test
    fun `what is no domain is refused`() {
        assertThrows(FileFormatException::class.java) { nodes("a.txt", "") }
        assertThrows(FileFormatException::class.java) { nodes("b.txt", "%PDF") }
        val binary = Files.write(directory.resolve("c.wkt"), byteArrayOf(-1, -2, 0, 1))
        assertThrows(FileFormatException::class.java) { DomainFormats.read(binary) }
        assertThrows(IOException::class.java) { DomainFormats.read(directory.resolve("none.wkt")) }
    }

    private fun nodes(name: String, text: String): Int =
        DomainFormats.read(Files.writeString(directory.resolve(name), text)).single().domain.nodeCount
}
