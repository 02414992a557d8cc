package org.trigrid.spark

import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.io.CurveDivision
import org.trigrid.io.DomainFormat
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.TriMesh
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes
import java.io.ByteArrayOutputStream
import java.io.NotSerializableException
import java.net.URLClassLoader
import kotlin.io.path.readText

class SparkMesherTest {
    private val plate = "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0), (0.5 0.4, 0.5 0.6, 0.7 0.6, 0.7 0.4, 0.5 0.4))"
    private val geoJson = """{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}"""
    private val division = CurveDivision.DEFAULT.withSpacing(0.1, 1.0)

    private fun bytes(mesh: TriMesh, format: MeshFormat) =
        ByteArrayOutputStream().also { MeshFormats.write(mesh, it, format) }.toByteArray()

    private fun Row.text(column: String) = getString(fieldIndex(column))

    private fun Row.int(column: String) = getInt(fieldIndex(column))

    private fun Row.isNull(column: String) = isNullAt(fieldIndex(column))

    @Test
    fun `arrays, figures and files are those of the library`() {
        val mesher = SparkMesher.builder().division(division).format(MeshFormat.VTU).build()
        val rows = mesher.mesh(LocalSpark.outlines("plate" to plate, "square" to geoJson)).collectAsList()
        assertEquals(listOf("plate", "square"), rows.map { it.text("id") })
        for ((row, text) in rows.zip(listOf(plate, geoJson))) {
            val domain = DomainFormats.parse(text, row.text("id"), null, division).single().domain
            val result = MeshGenerator.generate(domain)
            val mesh = result.mesh
            assertNull(row.getAs<String>("error"))
            assertArrayEquals(bytes(mesh, MeshFormat.VTU), row.getAs<ByteArray>("file"))
            assertArrayEquals(mesh.nodeCoordinates(), row.getList<Double>(row.fieldIndex("coordinates")).toDoubleArray())
            assertArrayEquals(mesh.elementNodes(), row.getList<Int>(row.fieldIndex("elementNodes")).toIntArray())
            assertEquals(mesh.tags, row.getList<String>(row.fieldIndex("tags")))
            val edges = row.getList<Int>(row.fieldIndex("edgeNodes"))
            assertEquals((0 until mesh.taggedEdgeCount).flatMap { listOf(mesh.edgeStart(it), mesh.edgeEnd(it)) }, edges)
            assertEquals((0 until mesh.taggedEdgeCount).map { mesh.edgeTag(it) }, row.getList<Int>(row.fieldIndex("edgeTags")))
            assertEquals(listOf(mesh.nodeCount, mesh.elementCount, mesh.boundaryEdgeCount), listOf("nodes", "elements", "boundaryEdges").map { row.int(it) })
            assertEquals(result.report.quality.minAngle, row.getAs<Double>("minAngle"))
            assertEquals(mesh.bandwidth, row.int("bandwidth"))
        }
    }

    @Test
    fun `the countries of the world, some of them faulty, in balanced partitions`() {
        val text = LocalSpark.world.readText()
        val outlines = LocalSpark.session().createDataFrame(
            listOf(RowFactory.create("world", text, "topojson")), LocalSpark.schema("id", "outline", "format"),
        )
        val mesher = SparkMesher.builder().arrays(false).format(MeshFormat.MSH_41_BINARY).elementsPerPartition(7_000).build()
        val meshes = mesher.mesh(outlines)
        val domains = DomainFormats.parse(text, "world", DomainFormat.TOPOJSON, CurveDivision.DEFAULT)
        val partitions = meshes.toJavaRDD().glom().collect()
        val rows = partitions.flatten()
        assertEquals(domains.indices.toList(), rows.map { it.int("domain") })
        assertEquals(10, rows.count { it.isNull("elements") })
        for (row in rows) {
            assertEquals(domains.size, row.int("domains"))
            assertEquals(domains[row.int("domain")].name, row.text("name"))
            if (row.isNull("elements")) assertEquals("DOMAIN", row.text("errorKind"))
            else if (row.int("domain") % 10 == 0) {
                val mesh = MeshGenerator.generate(domains[row.int("domain")].domain).mesh
                assertArrayEquals(bytes(mesh, MeshFormat.MSH_41_BINARY), row.getAs<ByteArray>("file"), row.text("name"))
            }
        }
        val work = partitions.map { part -> part.sumOf { ElementBalance.LEAST + if (it.isNull("elements")) 0 else it.int("elements") } }
        val largest = rows.maxOf { if (it.isNull("elements")) 0 else it.int("elements") }
        assertTrue(partitions.size >= 10)
        assertTrue(work.max() < 1.25 * (work.sum() / work.size + largest), "$work")
    }

    @Test
    fun `bad outlines are rows with what is wrong, and where`() {
        val outlines = LocalSpark.outlines(
            "bow tie" to "POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))", "half" to "POLYGON ((0 0, 1 0,\n 1 x))", "none" to null,
            "good" to plate, "points" to "words",
        )
        val rows = SparkMesher.builder().build().mesh(outlines).collectAsList().associateBy { it.text("id") }
        assertEquals(setOf("bow tie", "half", "none", "good", "points"), rows.keys)
        val tie = rows.getValue("bow tie")
        assertEquals("DOMAIN", tie.text("errorKind"))
        val fault = tie.getList<Row>(tie.fieldIndex("faults")).single()
        assertEquals("CROSSING", fault.text("kind"))
        assertEquals(1.0, fault.getAs<Double>("x"), 1e-12)
        assertEquals(2.0 / 3, fault.getAs<Double>("y"), 1e-12)
        assertEquals(listOf(0, 1, 2, 3), fault.getList<Int>(fault.fieldIndex("nodes")).sorted())
        val half = rows.getValue("half")
        assertEquals(listOf("FORMAT", 2, -1, 0), listOf(half.text("errorKind"), half.int("line"), half.int("domain"), half.int("domains")))
        assertTrue("half" !in half.text("error"), half.text("error"))
        assertEquals("FILE", rows.getValue("none").text("errorKind"))
        assertEquals("FORMAT", rows.getValue("points").text("errorKind"))
        assertNull(rows.getValue("good").getAs<String>("error"))
    }

    @Test
    fun `options travel, a size function too`() {
        val sizes = TravellingSizeFunction { x, _ -> 0.02 + 0.1 * x }
        val options = MeshOptions.builder().sizes(Sizes.GRADE).sizeFunction(sizes)
            .sizeSources(SizeSources.NONE.withPoint(0.01, 1.5, 0.5).withLine(0.05, 0.0, 0.2, 1.0, 0.2)).maxElements(100_000).build()
        val mesher = SparkMesher.builder().options(options).division(division).build()
        val row = mesher.mesh(LocalSpark.outlines("plate" to plate)).first()
        val expected = MeshGenerator.generate(DomainFormats.parse(plate, "plate", null, division).single().domain, options).mesh
        assertEquals(expected.elementCount, row.int("elements"))
        val fixed = MeshOptions.builder().sizeFunction { _, _ -> 0.1 }.build()
        val error = assertThrows<Exception> { SparkMesher.builder().options(fixed).build().mesh(LocalSpark.outlines("plate" to plate)) }
        assertTrue(generateSequence<Throwable>(error) { it.cause }.any { it is NotSerializableException }, error.toString())
    }

    @Test
    fun `too many elements, and a size function that fails, are errors of their own kinds`() {
        val few = SparkMesher.builder().options(MeshOptions.builder().maxElements(3).build()).division(division).build()
        assertEquals("TOO_LARGE", few.mesh(LocalSpark.outlines("plate" to plate)).first().text("errorKind"))
        val negative = MeshOptions.builder().sizeFunction(TravellingSizeFunction { _, _ -> -1.0 }).build()
        assertEquals("SIZE", SparkMesher.builder().options(negative).build().mesh(LocalSpark.outlines("plate" to plate)).first().text("errorKind"))
        val failing = MeshOptions.builder().sizeFunction(TravellingSizeFunction { _, _ -> error("no size today") }).build()
        val row = SparkMesher.builder().options(failing).build().mesh(LocalSpark.outlines("plate" to plate)).first()
        assertEquals("DEFECT", row.text("errorKind"))
        assertTrue("no size today" in row.text("error"))
    }

    @Test
    fun `second order, and outlines that stay in their partitions`() {
        val outlines = LocalSpark.outlines("a" to plate, "b" to geoJson, "c" to plate).repartition(2)
        val mesher = SparkMesher.builder().division(division).order(2).elementsPerPartition(0).build()
        val meshes = mesher.mesh(outlines)
        assertEquals(2, meshes.toJavaRDD().numPartitions)
        val row = meshes.filter("id = 'b'").first()
        assertEquals(6 * row.int("elements"), row.getList<Int>(row.fieldIndex("elementNodes")).size)
        assertEquals(2 * row.int("nodes"), row.getList<Double>(row.fieldIndex("coordinates")).size)
        assertEquals(0, row.getList<Int>(row.fieldIndex("edgeNodes")).size % 3)
    }

    @Test
    fun `whichever class a machine needs first can be the first`() {
        val classes = arrayOf(MeshColumns::class.java.protectionDomain.codeSource.location)
        for (name in listOf("FaultRows", "FailureRows", "MeshColumns", "ColumnsSink", "ElementBalance", "DomainMeshing")) {
            // A loader of its own, where nothing is initialized yet.
            object : URLClassLoader(classes, javaClass.classLoader) {
                override fun loadClass(name: String, resolve: Boolean): Class<*> =
                    if (name.startsWith("org.trigrid.spark.")) findLoadedClass(name) ?: findClass(name) else super.loadClass(name, resolve)
            }.use { Class.forName("org.trigrid.spark.$name", true, it) }
        }
    }

    @Test
    fun `regions and points are columns`() {
        val geo = "Point(1)={0,0,0}; Point(2)={1,0,0}; Point(3)={1,1,0}; Point(4)={0,1,0}; Point(5)={2,0,0}; Point(6)={2,1,0}; Point(7)={0.5,0.4,0};" +
            "Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1}; Line(5)={2,5}; Line(6)={5,6}; Line(7)={6,3};" +
            "Curve Loop(1)={1:4}; Curve Loop(2)={5,6,7,-2}; Plane Surface(1)={1}; Plane Surface(2)={2}; Point{7} In Surface{1};" +
            "Physical Surface(\"steel\",3)={1}; Physical Surface(\"rubber\",8)={2}; Physical Point(\"load\")={7};"
        val outlines = LocalSpark.session().createDataFrame(listOf(RowFactory.create("plate", geo, "geo")), LocalSpark.schema("id", "outline", "format"))
        for (order in 1..2) {
            val row = SparkMesher.builder().division(division).order(order).build().mesh(outlines).first()
            assertNull(row.getAs<String>("error"))
            val regions = row.getList<String>(row.fieldIndex("regions"))
            assertEquals(mapOf("steel" to 3, "rubber" to 8), regions.zip(row.getList<Int>(row.fieldIndex("materials"))).toMap())
            val xy = row.getList<Double>(row.fieldIndex("coordinates"))
            val elements = row.getList<Int>(row.fieldIndex("elementNodes")).chunked(3 * order)
            for ((element, region) in elements.zip(row.getList<Int>(row.fieldIndex("elementRegions")))) {
                assertEquals(if (element.take(3).sumOf { xy[2 * it] } < 3) "steel" else "rubber", regions[region])
            }
            val node = row.getList<Int>(row.fieldIndex("pointNodes")).single()
            assertEquals(listOf(0.5, 0.4), xy.subList(2 * node, 2 * node + 2))
            assertEquals("load", row.getList<String>(row.fieldIndex("tags"))[row.getList<Int>(row.fieldIndex("pointTags")).single()])
        }
    }

    @Test
    fun `columns that are missing or of another type are told before any work`() {
        val mesher = SparkMesher.builder().build()
        val session = LocalSpark.session()
        val missing = assertThrows<IllegalArgumentException> { mesher.mesh(session.sql("SELECT 'a' AS id, 'b' AS wkt")) }
        assertTrue("\"outline\"" in missing.message.orEmpty() && "wkt" in missing.message.orEmpty(), missing.message)
        assertThrows<IllegalArgumentException> { mesher.mesh(session.sql("SELECT 1 AS id, 'b' AS outline")) }
        assertThrows<IllegalArgumentException> { SparkMesher.builder().format(MeshFormat.TRIANGLE) }
        assertThrows<IllegalArgumentException> { SparkMesher.builder().order(2).format(MeshFormat.SU2).build() }
        assertThrows<IllegalArgumentException> { SparkMesher.builder().order(3) }
    }
}
