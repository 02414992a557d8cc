package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.DomainCheck

class PointFilesTest {
    private fun area(text: String) = DrawingTexts.one(DomainFormat.POINTS, text).area

    @Test
    fun `points in all ways of writing`() {
        assertEquals(0.5, area("x,y\n0,0\n1,0\n1,1\n"))
        assertEquals(0.5, area("0 0\r\n1\t0 7\r\n1 1\r\n0 0"))
        assertEquals(0.125, area("# a comment\nX;Y\n0;0\n0,5;0\n0,5;0,5"))
        assertEquals(0.5, area("NACA 0012 AIRFOIL\n  0.0  0.0\n 1.0 0.0\n 1. 1.\n"))
        val ring = DrawingTexts.one(DomainFormat.POINTS, "0,0\n9,0\n9,9\n0,9\n\n\n3,3\n4,3\n4,4\n")
        assertEquals(80.5, ring.area)
        assertEquals(listOf("outer", "hole_1"), ring.tags)
    }

    @Test
    fun `a line that is no point is named`() {
        val error = assertThrows(FileFormatException::class.java) { area("0,0\n1,0\n1,a\n") }
        assertEquals(3, error.line)
        assertThrows(FileFormatException::class.java) { area("") }
        assertThrows(FileFormatException::class.java) { area("1\n2\n") }
    }

    @Test
    fun `TopoJSON joins arcs and undoes the quantization`() {
        val text = """{"type": "Topology", "transform": {"scale": [0.5, 2], "translate": [10, 20]},
            "objects": {"land": {"type": "GeometryCollection", "geometries": [
              {"type": "Polygon", "properties": {"name": "left"}, "arcs": [[0, 1]]},
              {"type": "MultiPolygon", "arcs": [[[2, -1]]]}, {"type": "Point", "coordinates": [0, 0]}, {"type": null}]}},
            "arcs": [[[2, 0], [0, 2]], [[2, 2], [-2, 0], [0, -2], [2, 0]], [[2, 0], [2, 0], [0, 2], [-2, 0]]]}"""
        for (format in listOf(DomainFormat.TOPOJSON, DomainFormat.GEOJSON)) {
            val (left, right) = DrawingTexts.read(format, text)
            assertEquals("left", left.name)
            assertEquals("drawing", right.name)
            assertEquals(4.0, left.domain.area)
            assertEquals(4.0, right.domain.area)
            assertEquals(10.0, left.domain.x(0).coerceAtMost(10.0))
            for (named in listOf(left, right)) assertEquals(emptyList<Any>(), DomainCheck.check(named.domain))
        }
        val error = assertThrows(FileFormatException::class.java) { DrawingTexts.read(DomainFormat.TOPOJSON, text.replace("[0, 1]", "[0, 7]")) }
        assertEquals(3, error.line)
    }
}
