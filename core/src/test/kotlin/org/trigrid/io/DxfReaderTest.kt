package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck

class DxfReaderTest {
    /** @param entities words: the type, then codes and values. */
    private fun dxf(vararg entities: String, units: Int = 0): String {
        val header = "0\nSECTION\n2\nHEADER\n9\n\$ACADVER\n1\nAC1015\n9\n\$INSUNITS\n70\n$units\n0\nENDSEC\n"
        return header + "  0\nSECTION\n  2\nENTITIES\n" + entities.joinToString("") { e ->
            val words = e.split(' ')
            "0\n" + words.joinToString("\n") + "\n"
        } + "0\nENDSEC\n0\nEOF\n"
    }

    private fun line(x0: Double, y0: Double, x1: Double, y1: Double, layer: String = "L") = "LINE 8 $layer 10 $x0 20 $y0 11 $x1 21 $y1"

    private fun read(text: String, division: CurveDivision = CurveDivision.DEFAULT): Domain = DrawingTexts.one(DomainFormat.DXF, text, division)

    private val fine = DrawingTexts.spaced(0.01)

    @Test
    fun `lines in any order and direction, twice drawn and with gaps, are joined`() {
        val text = dxf(
            line(0.0, 0.0, 4.0, 0.0, "low"), line(4.0, 3.0, 0.0, 3.0), line(4.0, 1e-7, 4.0, 3.0), line(0.0, 3.0, 0.0, 0.0), line(0.0, 0.0, 0.0, 3.0),
            line(7.0, 7.0, 7.0, 7.0), "TEXT 10 1 20 1 40 2 1 note",
        )
        val domain = read(text)
        assertEquals(12.0, domain.area)
        assertEquals(4, domain.nodeCount)
        assertEquals(listOf("low", "L"), domain.tags)
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
    }

    @Test
    fun `an open outline tells where, how far, and what joins it`() {
        val text = dxf(line(0.0, 0.0, 4.0, 0.0), line(4.0, 0.0, 4.0, 3.0), line(4.0, 3.0, 0.0, 0.01))
        val error = assertThrows(FileFormatException::class.java) { read(text) }
        assertTrue("open at (0.0, 0.0)" in error.message!! && "0.01 away" in error.message!!, error.message)
        assertEquals(6.0, read(text, CurveDivision.DEFAULT.withJoin(0.02)).area, 0.1)
        val fork = dxf(line(0.0, 0.0, 1.0, 0.0), line(1.0, 0.0, 1.0, 1.0), line(1.0, 1.0, 0.0, 0.0), line(0.0, 0.0, -1.0, -1.0))
        assertTrue("3 pieces" in assertThrows(FileFormatException::class.java) { read(fork) }.message!!)
    }

    @Test
    fun `arcs, circles and ellipses`() {
        assertEquals(Math.PI, read(dxf("CIRCLE 10 5 20 5 40 1"), fine).area, 1e-3)
        assertEquals(Math.PI / 2 + 2, read(dxf("ARC 10 0 20 0 40 1 50 0 51 180", line(-1.0, 0.0, -1.0, -1.0), line(-1.0, -1.0, 1.0, -1.0), line(1.0, -1.0, 1.0, 0.0)), fine).area, 1e-3)
        // From 270 to 90 degrees, on the right.
        val right = read(dxf("ARC 10 0 20 0 40 1 50 270 51 90", line(0.0, 1.0, 0.0, -1.0)), fine)
        assertEquals(1.0, (0 until right.nodeCount).maxOf { right.x(it) }, 1e-3)
        // Seen from below, on the left.
        val left = read(dxf("ARC 10 0 20 0 40 1 50 270 51 90 210 0 220 0 230 -1", line(0.0, 1.0, 0.0, -1.0)), fine)
        assertEquals(-1.0, (0 until left.nodeCount).minOf { left.x(it) }, 1e-3)
        assertEquals(6 * Math.PI, read(dxf("ELLIPSE 10 1 20 1 11 0 21 3 40 0.666666666666667 41 0 42 6.283185"), fine).area, 1e-2)
        val ring = read(dxf("CIRCLE 10 0 20 0 40 2", "CIRCLE 10 0 20 0 40 1"), fine)
        assertEquals(3 * Math.PI, ring.area, 1e-2)
    }

    @Test
    fun `polylines with bulges`() {
        // A square whose right side is a half circle outwards.
        val light = "LWPOLYLINE 90 4 70 1 10 0 20 0 10 2 20 0 42 1 10 2 20 2 10 0 20 2"
        assertEquals(4 + Math.PI / 2, read(dxf(light), fine).area, 1e-3)
        val old = arrayOf(
            "POLYLINE 66 1 70 1", "VERTEX 10 0 20 0", "VERTEX 10 2 20 0 42 -1", "VERTEX 10 2 20 2", "VERTEX 10 0 20 2", "SEQEND 8 0",
        )
        assertEquals(4 - Math.PI / 2, read(dxf(*old), fine).area, 1e-3)
        val turned = read(dxf("LWPOLYLINE 90 2 70 1 10 -1 20 0 42 0.41421356237309503 10 0 20 -1 42 0"), fine)
        assertEquals(Math.PI / 4 - 0.5, turned.area, 1e-4)
    }

    @Test
    fun `splines, rational ones too`() {
        val bezier = "SPLINE 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 1 10 1 20 1 10 1 20 0"
        assertEquals(0.6, read(dxf(bezier, line(0.0, 0.0, 1.0, 0.0)), fine).area, 1e-4)
        val w = 0.7071067811865476
        val quarter = "SPLINE 70 4 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 $w 41 1 10 1 20 0 10 1 20 1 10 0 20 1"
        val quadrant = read(dxf(quarter, line(0.0, 1.0, 0.0, 0.0), line(0.0, 0.0, 1.0, 0.0)), fine)
        assertEquals(Math.PI / 4, quadrant.area, 1e-4)
        for (n in 0 until quadrant.nodeCount) {
            val r = Math.hypot(quadrant.x(n), quadrant.y(n))
            if (quadrant.x(n) > 0 && quadrant.y(n) > 0) assertEquals(1.0, r, 1e-12)
        }
    }

    @Test
    fun `units are converted where they are asked for`() {
        val inch = dxf("LWPOLYLINE 90 3 70 1 10 0 20 0 10 1 20 0 10 0 20 1", units = 1)
        assertEquals(0.5, read(inch).area)
        assertEquals(0.5 * 25.4 * 25.4, read(inch, CurveDivision.DEFAULT.withUnit(LengthUnit.MILLIMETRE)).area, 1e-9)
        val none = dxf("CIRCLE 10 0 20 0 40 1")
        assertThrows(FileFormatException::class.java) { read(none, CurveDivision.DEFAULT.withUnit(LengthUnit.METRE)) }
    }

    @Test
    fun `what cannot be read is refused with its line`() {
        fun fault(text: String) = assertThrows(FileFormatException::class.java) { read(text) }
        val insert = fault(dxf("CIRCLE 10 0 20 0 40 1", "INSERT 2 A 10 0 20 0"))
        assertTrue("explode" in insert.message!!)
        assertEquals(27, insert.line)
        assertTrue("group code" in fault("0\nSECTION\nx\ny\n").message!!)
        assertTrue("binary" in fault("AutoCAD Binary DXF\r\n\u001a\u0000").message!!)
        assertTrue("not a number" in fault(dxf("CIRCLE 10 a 20 0 40 1")).message!!)
        assertTrue("no closed outline" in fault(dxf("TEXT 10 0 20 0")).message!!)
        assertTrue("plane" in fault(dxf("CIRCLE 10 0 20 0 40 1 210 1 220 0 230 0")).message!!)
    }
}
