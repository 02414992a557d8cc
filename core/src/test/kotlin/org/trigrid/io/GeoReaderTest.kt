package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck

class GeoReaderTest {
    private fun read(text: String, division: CurveDivision = CurveDivision.DEFAULT): Domain = DrawingTexts.one(DomainFormat.GEO, text, division)

    private val plate = """
        // A plate with a hole.
        SetFactory("Built-in");
        h = 2; r = h / 4; lc = 0.5;
        Mesh.Algorithm = 6; General.Terminal = 1;
        Point(1) = {0, 0, 0, lc}; Point(2) = {2*h, 0, 0, lc}; Point(3) = {2*h, h, 0, lc/5}; Point(4) = {0, h, 0, lc/5};
        Point(10) = {h, h/2, 0}; Point(11) = {h + r, h/2, 0, 0.1}; Point(12) = {h - r, h/2, 0, 0.1};
        Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
        Circle(5) = {11, 10, 12}; Circle(6) = {12, 10, 11};
        Curve Loop(1) = {1:4}; Line Loop(2) = {5, 6};
        Plane Surface(1) = {1, 2};
        Physical Curve("bottom", 7) = {1}; Physical Line(8) = {5, -6};
        Physical Surface("steel") = {1}; /* done */
        Mesh 2;
    """.trimIndent()

    @Test
    fun `a plate with a hole, divided by the sizes at its points`() {
        val named = DrawingTexts.read(DomainFormat.GEO, plate).single()
        val domain = named.domain
        assertEquals("steel", named.name)
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(listOf("bottom", "boundary", "curve 8"), domain.tags)
        val lengths = (0 until domain.segmentCount).groupBy({ domain.tags[domain.segmentTag(it)] }, { domain.segmentLength(it) })
        assertEquals(8, lengths.getValue("bottom").size)
        assertEquals(0.5, lengths.getValue("bottom").max(), 1e-12)
        // Half circles of length pi / 2 and size 0.1.
        assertEquals(32, lengths.getValue("curve 8").size)
        // Between sizes 0.5 and 0.1 a length of 2 has 2 ln 5 / 0.4 = 8.05 edges, which shrink like the sizes.
        assertEquals(8 + 40 + 8, lengths.getValue("boundary").size)
        val graded = lengths.getValue("boundary").filter { it !in 0.0999..0.1001 }.sorted()
        assertEquals(5.0, graded.last() / graded.first(), 0.01)
        assertEquals(8 - Math.PI / 4, domain.area, 0.01)
    }

    @Test
    fun `a spacing takes the place of the sizes`() {
        // 8 + 4 + 8 + 4 edges round the plate, 3 on each half circle.
        assertEquals(24 + 6, read(plate, DrawingTexts.spaced(0.5)).nodeCount)
    }

    @Test
    fun `splines go where Gmsh's go`() {
        val points = "Point(1)={0,0,0}; Point(2)={1,2,0}; Point(3)={3,3,0}; Point(4)={4,0,0}; Point(5)={2,-1,0}; Point(6)={7,-1,0};\n"
        fun curve(statement: String): PlaneCurve = GeoReader(GeoTokens("$points$statement;", "x.geo")).read().curves.getValue(1)
            .curve
        fun at(curve: PlaneCurve, share: Double) = doubleArrayOf(
            curve.x(curve.knots.first() + share * (curve.knots.last() - curve.knots.first())),
            curve.y(curve.knots.first() + share * (curve.knots.last() - curve.knots.first())),
        )
        fun check(statement: String, share: Double, x: Double, y: Double) {
            val place = at(curve(statement), share)
            assertEquals(x, place[0], 1e-8, statement)
            assertEquals(y, place[1], 1e-8, statement)
        }
        // Values of gmsh 4.15.2 at the same parameters.
        check("Spline(1) = {1,2,3,4}", 0.25, 0.6796875, 1.5703125)
        check("Spline(1) = {1,2,3,4}", 0.75, 3.3203125, 2.53125)
        check("Spline(1) = {1,2,3,4,5,1}", 0.25, 1.453125, 2.4140625)
        check("BSpline(1) = {1,2,3}", 0.25, 0.5625, 0.9375)
        check("BSpline(1) = {1,2,3,4,5}", 0.25, 1.46875, 1.9375)
        check("BSpline(1) = {1,2,3,4,5,6}", 0.5, 3.375, 1.4375)
        check("BSpline(1) = {1,2,3,4,5,1}", 0.0, 0.5, 0.166666667)
        check("BSpline(1) = {1,2,3,4,5,1}", 0.25, 1.567708333, 2.169270833)
        check("Bezier(1) = {1,2,3,4}", 0.75, 3.09375, 1.546875)
    }

    @Test
    fun `ellipses, and curves listed in any order`() {
        val text = """
            Point(1)={0,0,0}; Point(2)={2,0,0}; Point(3)={0,1,0}; Point(4)={5,0,0};
            Ellipse(1)={2,1,4,3}; Line(2)={1,3}; Line(3)={1,2};
            Curve Loop(1)={3,2,1}; Plane Surface(1)={1};
        """.trimIndent()
        assertEquals(Math.PI / 2, read(text, DrawingTexts.spaced(0.01)).area, 1e-3)
    }

    @Test
    fun `transfinite curves have the nodes asked for`() {
        val text = plate.replace("Mesh 2;", "Transfinite Curve {1, -3} = 5 Using Progression 2;")
        val domain = read(text)
        val bottom = (0 until domain.segmentCount).filter { domain.tags[domain.segmentTag(it)] == "bottom" }.map { domain.segmentLength(it) }
        assertEquals(4, bottom.size)
        for (i in 0..3) assertEquals((4 shl i) / 15.0, bottom[i], 1e-12)
    }

    @Test
    fun `new numbers`() {
        val text = """
            a = newp; Point(a) = {0, 0, 0}; b = newp; Point(b) = {1, 0, 0}; c = newp; Point(c) = {0, 1, 0};
            i = newl; Line(i) = {a, b}; Line(newl) = {b, c}; j = newc; Line(j) = {c, a};
            Curve Loop(newll) = {i:j}; Plane Surface(news) = {1};
        """.trimIndent()
        assertEquals(0.5, read(text).area)
    }

    @Test
    fun `arithmetic`() {
        fun value(expression: String) = GeoExpressions(GeoTokens(expression, "x.geo")).number()
        assertEquals(7.0, value("1 + 2 * 3"))
        assertEquals(-8.0, value("-2 ^ 3"))
        assertEquals(512.0, value("2^3^2"))
        assertEquals(2.5, value("10 / (2 + 2)"))
        assertEquals(1.0, value("Sin(Pi/2)"))
        assertEquals(5.0, value("Sqrt[3*3 + 4*4]"))
        assertEquals(1e-3, value("1e-3"))
        assertEquals(-1.0, value("2 - 3"))
    }

    @Test
    fun `what cannot be read is an error with its place`() {
        fun fault(text: String) = assertThrows(FileFormatException::class.java) { read(text) }
        val error = fault("Point(1) = {0, 0, 0};\n  Extrude {0,0,1} { Point{1}; }")
        assertEquals(2, error.line)
        assertEquals(3, error.column)
        assertTrue("Extrude" in error.message!!)
        assertTrue("z = 1" in fault("Point(1) = {0, 0, 1};").message!!)
        assertTrue("no variable lc" in fault("Point(1) = {0, 0, 0, lc};").message!!)
        assertTrue("no point 2" in fault("Point(1) = {0, 0, 0}; Line(1) = {1, 2};").message!!)
        assertTrue("no Plane Surface" in fault("a = 1;").message!!)
        assertTrue("not closed" in fault("Point(1)={0,0,0};Point(2)={1,0,0};Line(1)={1,2};Line Loop(1)={1};Plane Surface(1)={1};").message!!)
        assertTrue("expected ';'" in fault("a = 1 b = 2;").message!!)
        assertTrue("For" in fault("For i In {1:3}").message!!)
    }
}
