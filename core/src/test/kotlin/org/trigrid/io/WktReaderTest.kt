package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.DomainCheck

class WktReaderTest {
    private val square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))"

    @Test
    fun `one geometry over many lines`() {
        val domain = read(square.replace(", ", ",\n")).single()
        assertEquals("file", domain.name)
        assertEquals(15.0, domain.domain.area)
        assertEquals(listOf("outer", "hole_1"), domain.domain.tags)
    }

    @Test
    fun `a geometry a line, with everything that is no polygon left out`() {
        val text = "# two\nSRID=4326;$square\nPOINT EMPTY\npolygon empty\nPOINT (1 2)\n\n" +
            "MULTIPOLYGON Z (((0 0 1, 1 0 1, 0 1 1, 0 0 1)), ((5 5 0, 7 5 0, 5 7 0, 5 5 0)))\n"
        val domains = read(text)
        assertEquals(listOf("file_1", "file_2", "file_3"), domains.map { it.name })
        assertEquals(listOf(15.0, 0.5, 2.0), domains.map { it.domain.area })
    }

    @Test
    fun `numbers are the nearest doubles`() {
        val domain = read("POLYGON ((0.1 5e-324, 1.7976931348623157E308 0.30000000000000004, -1e-7 3, 0.1 5e-324))").single().domain
        assertEquals(listOf(0.1, 5e-324, Double.MAX_VALUE, 0.1 + 0.2, -1e-7, 3.0), domain.nodeCoordinates().toList())
    }

    @Test
    fun `repeated points stay`() {
        val domain = read("POLYGON ((0 0, 4 0, 4 0, 4 4, 0 0))").single().domain
        assertEquals(setOf(FaultKind.ZERO_LENGTH), DomainCheck.check(domain).map { it.kind }.toSet())
    }

    @Test
    fun `errors tell the line`() {
        assertEquals(3, failure("$square\n\nPOLYGON ((0 0, 1 x, 0 1, 0 0))").line)
        assertEquals(4, failure("# a\n$square\nPOLYGON ((0 0,\n 1 x, 0 1, 0 0))").line)
        assertEquals(1, failure("POLYGON ((0 0, 1 0, 0 1))").line)
        assertEquals(2, failure("$square\nPOLYGON ((0 0, 1 0, 0 1, 0 0)").line)
        assertEquals(1, failure("HEXAGON ((0 0, 1 0, 0 1, 0 0))").line)
        assertEquals(0, failure("POINT (1 2)").line)
        assertEquals(0, failure("").line)
    }

    private fun failure(text: String) = assertThrows(FileFormatException::class.java) { read(text) }

    private fun read(text: String) = WktReader.read(text, "file.wkt", "file")
}
