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
    private fun dxf(vararg entities: String, units: Int = 0, blocks: String = ""): String {
        val header = "0\nSECTION\n2\nHEADER\n9\n\$ACADVER\n1\nAC1015\n9\n\$INSUNITS\n70\n$units\n0\nENDSEC\n" +
            (if (blocks.isEmpty()) "" else "0\nSECTION\n2\nBLOCKS\n" + pairs(*blocks.split("; ").toTypedArray()) + "0\nENDSEC\n")
        return header + "  0\nSECTION\n  2\nENTITIES\n" + pairs(*entities) + "0\nENDSEC\n0\nEOF\n"
    }

    private fun pairs(vararg entities: String) = entities.joinToString("") { e -> "0\n" + e.split(' ').joinToString("\n") + "\n" }

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

    /** A square of side 2 about (10, 20), the base point, on layer 0, with a hole in a block of its own. */
    private val plate = "BLOCK 8 0 2 Plate 70 0 10 10 20 20; LWPOLYLINE 8 0 90 4 70 1 10 9 20 19 10 11 20 19 10 11 20 21 10 9 20 21; " +
        "INSERT 8 holes 2 HOLE 10 10 20 20; ENDBLK; BLOCK 2 hole 10 0 20 0; CIRCLE 8 0 10 0 20 0 40 0.5; ENDBLK; " +
        "BLOCK 2 *D1 10 0 20 0; SOLID 10 0 20 0; CIRCLE 10 x 20 0 40 1; POINT 10 0 20 0; ENDBLK"

    @Test
    fun `blocks go where they are inserted, scaled, turned and mirrored`() {
        fun box(domain: Domain) = listOf(
            (0 until domain.nodeCount).minOf { domain.x(it) }, (0 until domain.nodeCount).minOf { domain.y(it) },
            (0 until domain.nodeCount).maxOf { domain.x(it) }, (0 until domain.nodeCount).maxOf { domain.y(it) },
        )
        fun check(domain: Domain, area: Double, vararg box: Double) {
            assertEquals(area, domain.area, 1e-3)
            for ((expected, found) in box.toList().zip(box(domain))) assertEquals(expected, found, 1e-9)
        }
        val hole = Math.PI / 4
        val moved = read(dxf("INSERT 8 outer 2 PLATE 10 5 20 6", blocks = plate), fine)
        check(moved, 4 - hole, 4.0, 5.0, 6.0, 7.0)
        // What is on layer 0 of a block is on the layer of the block.
        assertEquals(setOf("outer", "holes"), moved.tags.toSet())
        // Twice as wide, then turned by a right angle: higher. The hole becomes an ellipse.
        check(read(dxf("INSERT 2 plate 10 0 20 0 41 2 42 1 50 90", blocks = plate), fine), 2 * (4 - hole), -1.0, -2.0, 1.0, 2.0)
        check(read(dxf("INSERT 2 plate 10 3 20 0 41 -1", blocks = plate), fine), 4 - hole, 2.0, -1.0, 4.0, 1.0)
        check(read(dxf("INSERT 2 plate 10 3 20 0 230 -1", blocks = plate), fine), 4 - hole, -4.0, -1.0, -2.0, 1.0)
        val inch = read(dxf("INSERT 2 plate 10 0 20 0", blocks = plate, units = 1), fine.withUnit(LengthUnit.MILLIMETRE))
        check(inch, (4 - hole) * 25.4 * 25.4, -25.4, -25.4, 25.4, 25.4)
    }

    @Test
    fun `blocks in rows and columns, turned as a whole`() {
        val outline = "LWPOLYLINE 90 4 70 1 10 -20 20 -20 10 20 20 -20 10 20 20 20 10 -20 20 20"
        val domain = read(dxf(outline, "INSERT 2 hole 10 1 20 2 50 90 70 3 71 2 44 4 45 5", blocks = plate), fine)
        assertEquals(7, domain.loopCount)
        assertEquals(1600 - 6 * Math.PI / 4, domain.area, 1e-2)
        val centres = (0 until domain.loopCount).filter { domain.isHole(it) }.map { loop ->
            val nodes = domain.loopNodes(loop)
            Math.round(nodes.map { domain.x(it) }.average()) to Math.round(nodes.map { domain.y(it) }.average())
        }
        // Columns run along y, rows against x.
        assertEquals((0..1).flatMap { row -> (0..2).map { (1L - 5 * row) to (2L + 4 * it) } }.toSet(), centres.toSet())
    }

    @Test
    fun `what is hidden or on paper is passed over`() {
        val domain = read(dxf("CIRCLE 10 0 20 0 40 1", "CIRCLE 10 9 20 0 40 2 67 1", "CIRCLE 10 9 20 0 40 3 60 1"), fine)
        assertEquals(Math.PI, domain.area, 1e-3)
    }

    @Test
    fun `blocks that cannot be read matter where they are used`() {
        fun fault(blocks: String, vararg entities: String) =
            assertThrows(FileFormatException::class.java) { read(dxf(*entities, blocks = blocks)) }
        val solid = fault(plate, "INSERT 2 *D1 10 0 20 0")
        assertTrue("SOLID" in solid.message!!, solid.message)
        assertTrue("in itself" in fault("BLOCK 2 a; INSERT 2 b; ENDBLK; BLOCK 2 b; INSERT 2 A; ENDBLK", "INSERT 2 a").message!!)
        assertTrue("by 0" in fault(plate, "INSERT 2 plate 41 0").message!!)
        assertTrue("too much" in fault(plate, "INSERT 2 plate 70 32000 71 32000").message!!)
        val bomb = (1..5).joinToString("; ") { "BLOCK 2 b$it; INSERT 2 b${it - 1} 70 100; ENDBLK" } + "; BLOCK 2 b0; CIRCLE 10 0 20 0 40 1; ENDBLK"
        assertTrue("pieces" in fault(bomb, "INSERT 2 b5").message!!)
        // A file that ends in the middle of a block.
        assertTrue("no closed outline" in assertThrows(FileFormatException::class.java) { read("0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nSOLID") }.message!!)
    }

    @Test
    fun `what cannot be read is refused with its line`() {
        fun fault(text: String) = assertThrows(FileFormatException::class.java) { read(text) }
        val insert = fault(dxf("CIRCLE 10 0 20 0 40 1", "INSERT 2 A 10 0 20 0"))
        assertTrue("no block A" in insert.message!!)
        assertEquals(27, insert.line)
        assertTrue("group code" in fault("0\nSECTION\nx\ny\n").message!!)
        assertTrue("binary" in fault("AutoCAD Binary DXF\r\n\u001a\u0000").message!!)
        assertTrue("not a number" in fault(dxf("CIRCLE 10 a 20 0 40 1")).message!!)
        assertTrue("no closed outline" in fault(dxf("TEXT 10 0 20 0")).message!!)
        assertTrue("plane" in fault(dxf("CIRCLE 10 0 20 0 40 1 210 1 220 0 230 0")).message!!)
    }
}
