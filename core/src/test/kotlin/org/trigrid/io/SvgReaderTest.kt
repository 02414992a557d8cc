package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck

class SvgReaderTest {
    private fun svg(body: String) = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\">$body</svg>"

    private fun path(d: String, division: CurveDivision = CurveDivision.DEFAULT): Domain =
        DrawingTexts.one(DomainFormat.SVG, svg("<path d=\"$d\"/>"), division)

    private fun places(domain: Domain) = (0 until domain.nodeCount).map { domain.x(it) to domain.y(it) }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "M 0 0 L 2 0 2 1 0 1 Z", "m0 0l2 0 0 1-2 0z", "M0,0H2V1H0Z", "m0 0h2v1h-2z", "M0 0 2 0 2 1 0 1 0 0", "M0 0 L2 0 L2 1 L0 1 L0 0 Z",
            "M.0.0L2e0,0+2+1L0 1z",
        ],
    )
    fun `straight commands in every way of writing`(d: String) {
        val domain = path(d)
        assertEquals(setOf(0.0 to 0.0, 2.0 to 0.0, 2.0 to -1.0, 0.0 to -1.0), places(domain).map { it.first to it.second + 0.0 }.toSet())
        assertEquals(2.0, domain.area)
    }

    @Test
    fun `curves have the area that they bound`() {
        val fine = DrawingTexts.spaced(0.01)
        assertEquals(Math.PI, path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z", fine).area, 1e-4)
        assertEquals(Math.PI, path("M1 0a1 1 0 01-2 0a1 1 0 012 0z", fine).area, 1e-4)
        // Three quarters of a circle and the square of the last quarter.
        assertEquals(0.75 * Math.PI + 1, path("M 1 0 A 1 1 0 1 1 0 -1 L 1 -1 Z", fine).area, 1e-3)
        // A parabola over a chord of length 2 and height 1: 4 / 3.
        assertEquals(4.0 / 3, path("M -1 0 Q 0 2 1 0 Z", fine).area, 1e-4)
        // T mirrors the control point: the parabola below weighs up the one above.
        assertEquals(16.0, path("M -1 0 Q 0 2 1 0 T 3 0 L 3 4 L -1 4 Z", fine).area, 1e-3)
        // Radii that are too small grow to a half circle.
        assertEquals(Math.PI / 2, path("M -1 0 A 0.1 0.1 0 0 0 1 0 Z", fine).area, 1e-4)
        // The cubic of a smooth command mirrors the control point before it.
        val smooth = places(path("M0 0C1 0 1 1 2 1S3 0 4 0L4 3L0 3Z", fine)).map { "%.9f %.9f".format(it.first, it.second) }
        val explicit = places(path("M0 0C1 0 1 1 2 1C3 1 3 0 4 0L4 3L0 3Z", fine)).map { "%.9f %.9f".format(it.first, it.second) }
        assertEquals(explicit, smooth)
    }

    @Test
    fun `basic shapes`() {
        val fine = DrawingTexts.spaced(0.02)
        fun area(body: String) = DrawingTexts.one(DomainFormat.SVG, svg(body), fine).area
        assertEquals(12.0, area("<rect x='1' y='1' width='4' height='3'/>"), 1e-9)
        assertEquals(12 - (4 - Math.PI) * 0.25, area("<rect x='1' y='1' width='4' height='3' rx='0.5'/>"), 1e-3)
        assertEquals(Math.PI * 4, area("<circle cx='1' cy='1' r='2'/>"), 1e-3)
        assertEquals(Math.PI * 6, area("<ellipse cx='1' cy='1' rx='2' ry='3'/>"), 1e-3)
        assertEquals(0.5, area("<polygon points='0,0 1,0 1,1'/>"), 1e-9)
    }

    @Test
    fun `transforms nest`() {
        val domain = DrawingTexts.one(
            DomainFormat.SVG,
            svg("<g transform='translate(10 20) scale(2)'><rect width='1' height='1' transform='rotate(90, 0, 0)skewX(0)'/></g>"),
        )
        assertEquals(setOf(10.0 to -20.0, 10.0 to -22.0, 8.0 to -22.0, 8.0 to -20.0), places(domain).toSet())
        val circle = DrawingTexts.one(DomainFormat.SVG, svg("<circle r='1' transform='matrix(2 0 1 3 0 0)'/>"), DrawingTexts.spaced(0.01))
        assertEquals(6 * Math.PI, circle.area, 1e-3)
    }

    @Test
    fun `holes, tags and lines inside`() {
        val domain = DrawingTexts.one(
            DomainFormat.SVG,
            svg(
                "<defs><rect width='99' height='99'/></defs><g id='plate'><path d='M0 0H9V9H0Z'/></g>" +
                    "<circle id='bore' cx='3' cy='3' r='1'/><line id='rib' x1='5' y1='5' x2='7' y2='7'/><text>hello</text>",
            ),
        )
        assertEquals(listOf("plate", "bore", "rib"), domain.tags)
        assertEquals(listOf(false, true), (0 until domain.loopCount).map { domain.isHole(it) })
        assertEquals(1, (0 until domain.segmentCount).count { domain.isEmbedded(it) })
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        // No part of the circle bends by more than ten degrees.
        assertEquals(36, domain.loopNodes(1).size)
    }

    @Test
    fun `faults have their places`() {
        fun fault(text: String) = assertThrows(FileFormatException::class.java) { DrawingTexts.one(DomainFormat.SVG, text) }
        assertEquals(2, fault("<svg>\n<path d='M 0 0 X 1'/></svg>").line)
        assertTrue("'X'" in fault("<svg>\n<path d='M 0 0 X 1'/></svg>").message!!)
        assertTrue("no closed outline" in fault("<svg><path d='M 0 0 L 1 0 L 1 1'/></svg>").message!!)
        assertTrue("<use>" in fault("<svg><use href='#a'/></svg>").message!!)
        assertTrue("user units" in fault("<svg><circle r='10%'/></svg>").message!!)
        assertTrue("begin with M" in fault("<svg><path d='L 1 1'/></svg>").message!!)
        assertTrue("well-formed" in fault("<svg><path></svg>").message!!)
        assertTrue("flag" in fault("<svg><path d='M0 0A1 1 0 2 0 1 1z'/></svg>").message!!)
        assertTrue("transform" in fault("<svg><g transform='spin(3)'/></svg>").message!!)
        assertTrue("<html>" in fault("<html/>").message!!)
    }
}
