package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.mesh.MeshCheck

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
        fun curve(statement: String): PlaneCurve = GeoReader(GeoTokens("$points$statement;", "x.geo")).read().curves[1]!!
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

    /** As users write it: holes in rows by loops, sizes afterwards, a switch, lists of what was made. */
    private val perforated = """
        DefineConstant[ n = {3, Min 1, Max 9, Name "Parameters/Holes"}, round = 1 ];
        lc = DefineNumber[ 0.5, Name "Parameters/lc" ];
        Point(1) = {0, 0, 0}; Point(2) = {n + 1, 0, 0}; Point(3) = {n + 1, 3, 0}; Point(4) = {0, 3, 0};
        For i In {1:4}
          Line(i) = {i, i % 4 + 1};
        EndFor
        loops[] = {};
        k = 0;
        For i In {1 : n}
          For (1 : 2)
            k++;
            p = newp; r = 0.2;
            x = i; y = k % 2 + 1;
            Point(p) = {x, y, 0}; Point(p + 1) = {x + r, y, 0}; Point(p + 2) = {x - r, y, 0};
            a = newc;
            If (round == 1 && r > 0)
              Circle(a) = {p + 1, p, p + 2}; Circle(a + 1) = {p + 2, p, p + 1};
            ElseIf (round == 2)
              Line(a) = {p, p, p};
            Else
              Line(a) = {p};
            EndIf
            all() += {a, a + 1};
            Curve Loop(a) = {a, a + 1};
            loops[] += a;
          EndFor
        EndFor
        For i In {5:1:1}
          Nonsense;
        EndFor
        Line Loop(1) = {1:4};
        Plane Surface(1) = {1, loops[]};
        Point(1000) = {0, 0.5, 0, lc}; Point(1001) = {n + 1, 0.5, 0, lc};
        Line(1000) = {1000, 1001};
        Characteristic Length {:} = lc;
        MeshSize {1, 2} = lc / 2;
        Physical Curve("holes") = {all[]};
        Transfinite Surface {1}; Recombine Surface {1};
        Printf("%g holes", #loops[]);
    """.trimIndent()

    @Test
    fun `loops, branches and lists`() {
        val domain = read(perforated)
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(7, domain.loopCount)
        assertEquals(12 - 6 * 0.04 * Math.PI, read(perforated, DrawingTexts.spaced(0.01)).area, 1e-3)
        val holes = (0 until domain.segmentCount).count { domain.tags[domain.segmentTag(it)] == "holes" }
        // By its sizes half a circle would be one edge; Gmsh makes three.
        assertEquals(6 * 2 * 3, holes)
        val bottom = (0 until domain.segmentCount).filter { domain.y(domain.segmentStart(it)) == 0.0 && domain.y(domain.segmentEnd(it)) == 0.0 }
        assertEquals(16, bottom.size)
    }

    @Test
    fun `curves inside of a surface, and whole circles`() {
        val text = """
            SetFactory("OpenCASCADE");
            Circle(1) = {0, 0, 0, 2}; Circle(2) = {0, 0, 0, 1, 0, Pi}; Curve Loop(1) = {1}; Plane Surface(1) = {1};
            Point(10) = {-0.5, -1, 0}; Point(11) = {0.5, -1, 0}; Line(10) = {10, 11};
            Curve{2, 10} In Surface{1};
        """.trimIndent()
        val domain = read(text, DrawingTexts.spaced(0.05))
        assertEquals(4 * Math.PI, domain.area, 0.01)
        val inner = (0 until domain.segmentCount).filter { domain.isEmbedded(it) }
        assertEquals(Math.PI + 1, inner.sumOf { domain.segmentLength(it) }, 1e-3)
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
    }

    /** A plate of two materials with an inclusion of a third in both, a hole, and a point of load. */
    private val materials = """
        lc = 0.3; Point(1) = {0, 0, 0, lc}; Point(2) = {2, 0, 0, lc}; Point(3) = {4, 0, 0, lc}; Point(4) = {4, 3, 0, lc / 3}; Point(5) = {2, 3, 0, lc};
        Point(6) = {0, 3, 0, lc}; Point(7) = {1, 1.5, 0, lc / 2}; Point(8) = {1.5, 1.5, 0, lc / 2}; Point(9) = {0.5, 1.5, 0, lc / 2}; Point(10) = {3, 2, 0, lc / 4};
        Point(11) = {3.5, 1, 0, lc}; Point(12) = {3.8, 1, 0, lc}; Point(13) = {3.2, 1, 0, lc};
        Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1}; Spline(7) = {5, 10, 2};
        Circle(8) = {8, 7, 9}; Circle(9) = {9, 7, 8}; Circle(10) = {12, 11, 13}; Circle(11) = {13, 11, 12};
        Curve Loop(1) = {1, -7, 5, 6}; Curve Loop(2) = {8, 9}; Curve Loop(3) = {2, 3, 4, 7}; Curve Loop(4) = {10, 11};
        Plane Surface(1) = {1, 2}; Plane Surface(2) = {-2}; Plane Surface(3) = {3, 4};
        Point(20) = {3.6, 2.5, 0}; Point{20} In Surface{3};
        Physical Surface("steel", 5) = {1}; Physical Surface("rubber", 7) = {2}; Physical Surface("lead", 9) = {3};
        Physical Curve("left") = {6}; Physical Curve("rim") = {10, 11}; Physical Point("load") = {20};
    """.trimIndent()

    @Test
    fun `several surfaces are the regions of one domain`() {
        for (division in listOf(CurveDivision.DEFAULT, DrawingTexts.spaced(0.17))) {
            val named = DrawingTexts.read(DomainFormat.GEO, materials, division).single()
            assertEquals("drawing", named.name)
            assertEquals(emptyList<Any>(), DomainCheck.check(named.domain))
            val mesh = MeshGenerator.generate(named.domain).mesh
            assertEquals(emptyList<Any>(), MeshCheck.check(mesh, named.domain))
            assertEquals(setOf("steel" to 5, "rubber" to 7, "lead" to 9), mesh.regions.map { it.name to it.material }.toSet())
            fun area(name: String) = mesh.elementsIn(name).sumOf { mesh.area(it) }
            assertEquals(Math.PI / 4, area("rubber"), 0.04)
            // What Gmsh 4.15 finds with a fine mesh.
            assertEquals(6.966, area("steel"), 0.06)
            assertEquals(3.969, area("lead"), 0.06)
            assertEquals(listOf("load"), (0 until mesh.pointCount).map { mesh.tags[mesh.pointTag(it)] })
            assertEquals(3.6, mesh.x(mesh.pointNode(0)))
            assertTrue(mesh.nodesOn("left").isNotEmpty() && mesh.nodesOn("rim").isNotEmpty())
        }
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
        assertEquals(1.0, value("1 + 1 == 2 && !(3 < 2)"))
        assertEquals(0.0, value("1 >= 2 || 2 != 2"))
        assertEquals(1.0, value("2 <= 2"))
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
        assertTrue("For has no end" in fault("For i In {1:3}").message!!)
        assertTrue("If has no end" in fault("If (1)").message!!)
        assertTrue("If has no end" in fault("If (0) a = 1; Else").message!!)
        assertTrue("no For" in fault("EndFor").message!!)
        assertTrue("no If" in fault("For i In {1:2} Else EndFor").message!!)
        assertTrue("go round" in fault("For i In {1:1000} For j In {1:1000} EndFor EndFor").message!!)
        assertTrue("too long" in fault("For i In {1:1000000000} EndFor").message!!)
        assertTrue("have more" in fault("For i In {1:1000} a[] = {1:10000}; EndFor").message!!)
        assertTrue("Macro" in fault("Macro Hole\nReturn").message!!)
        assertTrue("Field" in fault("Field[1] = Distance;").message!!)
        assertTrue("no surface 1" in fault("Point{1} In Surface{1};").message!!)
        assertTrue("no place 3" in fault("a[] = {1, 2}; b = a[3];").message!!)
    }
}
