package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import java.nio.file.Files
import java.nio.file.Path

class PolyReaderTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `points beside it, numbered from zero, with attributes and no markers`() {
        Files.writeString(directory.resolve("part.node"), "4 2 1 0\n0 0.1 0 7\n1 4 0 7\n\n3 0 4 7 # last but one\n2 4 4 7\n")
        val domain = read("part.poly", "# nothing here\n0 2 1 0\n4 0\n0 1 0\n1 1 2\n2 2 3\n3 0 3\n0\n")
        assertEquals(listOf(0.1, 0.0, 4.0, 0.0, 0.0, 4.0, 4.0, 4.0), domain.nodeCoordinates().toList())
        assertArrayEquals(intArrayOf(0, 1, 3, 2), domain.loopNodes(0))
        assertEquals(listOf("boundary"), domain.tags)
        assertEquals("part", domain.regionName)
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
    }

    @Test
    fun `faces, islands and lines are told apart`() {
        val shapes = LineWorkText()
        shapes.square(0, 0, 20)
        shapes.square(2, 2, 10)
        shapes.square(4, 4, 4)
        shapes.square(14, 14, 2)
        shapes.square(30, 0, 5)
        shapes.line(3, 18, 9, 18)
        val domain = read("all.poly", shapes.text("2\n1 3 3\n2 15 15\n"))
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(400.0 - 100.0 + 16.0 - 4.0 + 25.0, domain.area)
        assertEquals(1, (0 until domain.segmentCount).count { domain.isEmbedded(it) })
        assertEquals(5, domain.loopCount)
    }

    @Test
    fun `a face without a hole point is domain, and its outline embedded`() {
        val shapes = LineWorkText()
        shapes.square(0, 0, 20)
        shapes.square(2, 2, 10)
        val domain = read("two.poly", shapes.text("0\n"))
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(400.0, domain.area)
        assertEquals(4, (0 until domain.segmentCount).count { domain.isEmbedded(it) })
    }

    @Test
    fun `a line outside of everything is a fault, not lost`() {
        val shapes = LineWorkText()
        shapes.square(0, 0, 20)
        shapes.line(30, 0, 40, 0)
        val faults = DomainCheck.check(read("stray.poly", shapes.text("0\n")))
        assertEquals(listOf(FaultKind.EMBEDDED_OUTSIDE), faults.map { it.kind })
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "3 2 0 0~1 0 0~2 1 x~3 0 1~0 0~0 | 3 | 5 | not a number",
            "3 2 0 0~1 0 0~1 1 0~3 0 1~0 0~0 | 3 | 1 | of that number already",
            "3 3 0 0~1 0 0 0~2 1 1 1 | 1 | 3 | two coordinates",
            "3 2 0 0~1 0 0~2 1 0~3 0 1~1 0~1 1 4~0 | 6 | 5 | no such point",
            "3 2 0 0~1 0 0~2 1 | 3 | 4 | missing",
            "3 2 0 0~1 0 0~ | 3 | 0 | ends before point 2 of 3",
            "900000000 2 0 0~1 0 0 | 1 | 1 | of this file",
            "-3 2 0 0 | 1 | 1 | not a number of points",
            "a b | 1 | 1 | not a whole number",
            "0 2 0 0 | 1 | 1 | no file bad.node",
        ],
    )
    fun `errors tell line and column`(text: String, line: Int, column: Int, reason: String) {
        val error = assertThrows(FileFormatException::class.java) { read("bad.poly", text.replace('~', '\n')) }
        assertEquals("$line:$column", "${error.line}:${error.column}", error.message)
        assertTrue(error.message!!.contains(reason)) { error.message }
    }

    private fun read(name: String, text: String): Domain {
        val file = directory.resolve(name)
        Files.writeString(file, text)
        return DomainFormats.read(file).single().domain
    }

    private class LineWorkText {
        private val points = ArrayList<String>()
        private val segments = ArrayList<String>()

        fun square(x: Int, y: Int, side: Int) {
            val first = points.size + 1
            for ((dx, dy) in listOf(0 to 0, 0 to side, side to side, side to 0)) points.add("${x + dx} ${y + dy}")
            for (i in 0 until 4) segments.add("${first + i} ${first + (i + 1) % 4}")
        }

        fun line(x0: Int, y0: Int, x1: Int, y1: Int) {
            points.add("$x0 $y0")
            points.add("$x1 $y1")
            segments.add("${points.size - 1} ${points.size}")
        }

        fun text(holes: String) = "${points.size} 2 0 0\n" + points.withIndex().joinToString("") { "${it.index + 1} ${it.value}\n" } +
            "${segments.size} 0\n" + segments.withIndex().joinToString("") { "${it.index + 1} ${it.value}\n" } + holes
    }
}
