package org.trigrid.reliability

import org.trigrid.MeshGenerator
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.InnerParts
import org.trigrid.domain.Path
import org.trigrid.domain.Region
import org.trigrid.geometry.Point2
import org.trigrid.io.DomainFormat
import org.trigrid.io.DomainText
import org.trigrid.io.GeoJsonReader
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.io.MshReader
import org.trigrid.io.MeditReader
import org.trigrid.io.PolyReader
import org.trigrid.io.TriangleReader
import org.trigrid.io.VtuReader
import org.trigrid.io.WktReader
import org.trigrid.project.Project
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.Line
import org.trigrid.shape.PaperShape
import org.trigrid.shape.PaperText
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import java.io.ByteArrayOutputStream
import java.nio.file.Path as FilePath

/** A kind of file that TriGrid reads: small valid samples, and how the text is read and then used. */
internal class FileKind(val name: String, val samples: List<String>, private val reader: (String) -> Unit) {
    fun read(text: String): Unit = reader(text)

    companion object {
        fun all(): List<FileKind> = listOf(
            FileKind("project", listOf(project(), regions())) { text ->
                // What a path or a domain refuses is told by TriGrid's own exceptions, after the file was read.
                try {
                    DomainCheck.check(ProjectFile.parse(text, "file").toDomain())
                } catch (e: org.trigrid.diagnostics.InvalidDomainException) {
                    check(e.faults.isNotEmpty())
                }
            },
            FileKind("geojson", listOf(GEOJSON, LOOPS)) { text -> GeoJsonReader.read(text, "file", "base").forEach { DomainCheck.check(it.domain) } },
            FileKind("wkt", listOf(WKT)) { text -> WktReader.read(text, "file", "base").forEach { DomainCheck.check(it.domain) } },
            FileKind("poly", listOf(POLY, POLY + "2\n1 1 0.5 2 -1\n2 3.5 3.5 0.5 0.01\n")) { text -> PolyReader.read(FilePath.of("none.poly"), text).forEach { DomainCheck.check(it.domain) } },
            FileKind("msh 2.2", listOf(mesh(MeshFormat.MSH_22), quadratic(MeshFormat.MSH_22))) { text -> MshReader.read(text.toByteArray(), "file") },
            FileKind("msh 4.1", listOf(mesh(MeshFormat.MSH_41), quadratic(MeshFormat.MSH_41))) { text -> MshReader.read(text.toByteArray(), "file") },
            FileKind("msh 2.2 binary", listOf(mesh(MeshFormat.MSH_22_BINARY), quadratic(MeshFormat.MSH_22_BINARY))) { text -> MshReader.read(bytes(text), "file") },
            FileKind("msh 4.1 binary", listOf(mesh(MeshFormat.MSH_41_BINARY), quadratic(MeshFormat.MSH_41_BINARY))) { text -> MshReader.read(bytes(text), "file") },
            FileKind("svg", listOf(SVG)) { text -> drawing(DomainFormat.SVG, text) },
            FileKind("dxf", listOf(DXF.replace(' ', '\n'))) { text -> drawing(DomainFormat.DXF, text) },
            FileKind("geo", listOf(GEO)) { text -> drawing(DomainFormat.GEO, text) },
            FileKind("points", listOf("x,y\n0,0\n4,0\n4.5,4e0\n\n1,1\n2,1\n2,2\n")) { text -> drawing(DomainFormat.POINTS, text) },
            FileKind("topojson", listOf(TOPOJSON)) { text -> drawing(DomainFormat.TOPOJSON, text) },
            FileKind("vtu", listOf(mesh(MeshFormat.VTU), quadratic(MeshFormat.VTU), VTU)) { text -> VtuReader.read(bytes(text), "file") },
            FileKind("medit", listOf(mesh(MeshFormat.MEDIT), quadratic(MeshFormat.MEDIT))) { text -> MeditReader.read(bytes(text), "file") },
            FileKind("triangle nodes", listOf(NODE)) { text -> triangle().read(text, ELE, null) },
            FileKind("triangle elements", listOf(ELE)) { text -> triangle().read(NODE, text, EDGE) },
            FileKind("triangle edges", listOf(EDGE)) { text -> triangle().read(NODE, ELE, text) },
        ) + paperShapes().map { (kind, text) -> FileKind("paper ${kind.name.lowercase()}", listOf(text)) { PaperText.read(kind, it, "file") } }

        private fun project(): String {
            val path = Path.of(Line(0.0, 0.0, 4.0, 0.0, 0.5).withName("low"))
                .appendOpening(Line(4.0, 0.0, 3.0, 1.0, 0.5), Circle(Point2(3.0, 1.0), Point2(2.5, 1.0), 0.4))
                .append(Arc(Point2(4.0, 0.0), Point2(4.0, 4.0), 90.0, 0.5))
                .append(Curve(listOf(Point2(4.0, 4.0), Point2(2.0, 4.5), Point2(0.0, 4.0)), 0.5)).close(0.5)
                .newLoop().append(Rectangle(1.0, 2.5, 1.5, 3.0, 0.3)).newLoop().append(Polygon(Point2(3.0, 3.0), Point2(3.3, 3.0), 5, 0.2))
            return ProjectFile.format(Project.builder().path(path.moveNode(2, 1.1, -0.1).deleteNode(5)).build())
        }

        private fun regions(): String {
            val path = Path.of(Rectangle(0.0, 0.0, 4.0, 4.0, 1.0)).newLoop().append(Rectangle(1.0, 1.0, 2.0, 2.0, 0.5))
            val inner = InnerParts.NONE.withRegion(Region.of("copper").withMaterial(2).withMaxSize(0.25), 1.5, 1.5)
                .withLine("cut", 3.0, 1.0, 3.0, 2.0).withLoop("ring", 2.5, 2.5, 3.5, 2.5, 3.0, 3.5).withPoint("probe", 0.5, 3.0)
            return ProjectFile.format(Project.builder().path(path).inner(inner).region(Region.of("iron").withMaterial(1)).build())
        }

        private fun square(): TriMesh {
            val domain = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), "rim")
                .embed(doubleArrayOf(0.2, 0.2, 0.4, 0.2), "line").embedLoop(doubleArrayOf(0.5, 0.5, 0.8, 0.5, 0.6, 0.8), "ring")
                .region(0.65, 0.6, Region.of("inner")).embedPoint(0.2, 0.7, "probe").build()
            return MeshGenerator.generate(domain).mesh
        }

        private fun mesh(format: MeshFormat): String {
            val out = ByteArrayOutputStream()
            MeshFormats.write(square(), out, format)
            return out.toString(Charsets.ISO_8859_1)
        }

        private fun quadratic(format: MeshFormat): String {
            val out = ByteArrayOutputStream()
            MeshFormats.write(QuadraticMesh.of(square()), out, format)
            return out.toString(Charsets.ISO_8859_1)
        }

        /** Samples of binary files are texts of one character a byte. */
        private fun bytes(text: String) = text.toByteArray(Charsets.ISO_8859_1)

        /** A damaged number may ask for more nodes than are allowed, which the exception for shapes tells. */
        private fun drawing(format: DomainFormat, text: String) {
            try {
                for (named in format.read(DomainText(FilePath.of("file"), text))) DomainCheck.check(named.domain)
            } catch (e: org.trigrid.diagnostics.InvalidShapeException) {
                check(e.message!!.isNotEmpty())
            }
        }

        private fun triangle() = TriangleReader(FilePath.of("t.node"), FilePath.of("t.ele"), FilePath.of("t.edge"))

        private fun paperShapes(): List<Pair<PaperShape, String>> {
            val a = Point2(0.0, 0.0)
            val b = Point2(2.0, 1.0)
            return listOf(
                PaperShape.LINE to Line(a, b, 0.5),
                PaperShape.CURVE to Curve(listOf(a, b, Point2(3.0, 3.0)), 0.5),
                PaperShape.RECTANGLE to Rectangle(a, b, 0.5),
                PaperShape.POLYGON to Polygon(a, b, 5, 0.5),
                PaperShape.CIRCLE to Circle(a, b, 0.5),
            ).map { (kind, shape) -> kind to PaperText.write(shape) }
        }

        private const val SVG = """<svg viewBox="0 0 9 9"><g id="a" transform="translate(1,2) rotate(30)"><path d="M0 0h9v9.5H0z
 M1 1C2 0 2 2 3 1S4 2 5 1T6 2A1 2 30 01 3 3Q2 3 1 1z"/></g><rect x="20" width="3" height="2" rx=".5"/><circle cx="30" r="2"/>
<polyline points="1,1 2,2"/></svg>"""

        private const val DXF = "0 SECTION 2 HEADER 9 \$INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 low 10 0 20 0 11 4 21 0 " +
            "0 LINE 10 4 20 0 11 4 21 3 0 LINE 10 4 20 3 11 0 21 0 0 CIRCLE 10 3 20 1 40 0.25 0 ELLIPSE 10 20 20 0 11 2 21 0 40 0.5 " +
            "0 LWPOLYLINE 70 1 10 30 20 0 10 32 20 0 42 1 10 32 20 2 0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 40 20 0 10 41 20 1 " +
            "10 42 20 0 0 LINE 10 40 20 0 11 42 21 0 0 ENDSEC 0 EOF"

        private const val GEO = """lc = 0.5 * 2; // size
Point(1) = {0, 0, 0, lc}; Point(2) = {4, 0, 0, lc/2}; Point(3) = {2, 3, 0}; Point(4) = {2, 0, 0};
Line(1) = {1, 2}; Spline(2) = {2, 3, 1}; Circle(3) = {1, 4, 2}; Curve Loop(1) = {1:2};
Transfinite Curve {1} = 5 Using Progression 1.1; Plane Surface(1) = {1}; Physical Curve("a") = {1}; Mesh 2;
"""

        private const val TOPOJSON = """{"type": "Topology", "transform": {"scale": [0.5, 2], "translate": [10, 20]}, "objects": {"land":
{"type": "GeometryCollection", "geometries": [{"type": "Polygon", "arcs": [[0, 1]]}, {"type": "MultiPolygon", "arcs": [[[2, -1]]]}]}},
"arcs": [[[2, 0], [0, 2]], [[2, 2], [-2, 0], [0, -2], [2, 0]], [[2, 0], [2, 0], [0, 2], [-2, 0]]]}"""

        private const val NODE = "# nodes\n4 2 1 1\n1 0 0 5 1\n2 1.5 0 5 1\n3 1 1e0 5 1\n7 0 1 5 0\n"
        private const val ELE = "2 3 1\n1 1 2 3 4\n2 1 3 7 4\n"
        private const val EDGE = "3 1\n1 1 2 3\n2 2 3 1\n3 3 1 0\n"

        private const val VTU = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" compressor="vtkZLibDataCompressor"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="3"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0  1 1 0  0 1e0 0</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 2 3 0 1</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5 5 3</DataArray></Cells>
<CellData><DataArray type="Int32" Name="tag" format="binary">AQAAAACAAAAMAAAACwAAAA==eJxjYIAARgAADAAC</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>"""

        private const val LOOPS = """{"name": "two", "loops": [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [2, 1], [1, 2]]]}"""

        private const val GEOJSON = """{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"name": "a"},
 "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4.5, 0], [4, 4e0], [0, 4], [0, 0]], [[1, 1], [2, 1], [1, 2], [1, 1]]]}},
 {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2]},
 {"type": "MultiPolygon", "coordinates": [[[[10, 0], [11, 0], [10, 1], [10, 0]]]]}]}}]}"""

        private const val WKT = """# two
SRID=4326;MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1)), ((10 0, 11 0, 10 1, 10 0)))
GEOMETRYCOLLECTION (POINT (1 2), POLYGON ((0 0, 1e0 0, 0 1.5, 0 0)), POLYGON EMPTY)
"""

        private const val POLY = """# a square with a hole
8 2 0 1
1 0 0 1
2 4 0 1
3 4 4 1
4 0 4 1
5 1 1 2
6 2 1 2
7 2 2 2
8 1 2 2
8 1
1 1 2 1
2 2 3 1
3 3 4 1
4 4 1 1
5 5 6 2
6 6 7 2
7 7 8 2
8 8 5 2
1
1 1.5 1.5
0
"""
    }
}
