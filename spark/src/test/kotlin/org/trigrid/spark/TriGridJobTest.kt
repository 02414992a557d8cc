package org.trigrid.spark

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import org.trigrid.cli.ExitCodes
import org.trigrid.spark.job.runJob
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readLines
import kotlin.io.path.writeText

/** Hadoop needs programs of its own to write to a disk of Windows. */
@DisabledOnOs(OS.WINDOWS)
class TriGridJobTest {
    @TempDir
    lateinit var folder: Path

    private class Outcome(val code: Int, val out: String, val err: String)

    private fun run(vararg arguments: Any): Outcome {
        val out = ByteArrayOutputStream()
        val err = ByteArrayOutputStream()
        val texts = arguments.map { it.toString() }.toTypedArray()
        val code = runJob(texts, PrintStream(out), PrintStream(err)) { LocalSpark.session() }
        return Outcome(code, out.toString(), err.toString())
    }

    private fun batch(vararg arguments: Any): Int =
        org.trigrid.cli.run(arguments.map { it.toString() }.toTypedArray(), PrintStream(ByteArrayOutputStream()), PrintStream(ByteArrayOutputStream()))

    /** Countries, a project, a table of points, a drawing, and files that cannot be meshed. */
    private fun outlines(): Path {
        val outlines = folder.resolve("the outlines").createDirectories()
        val data = Path.of("..", "src-test-data")
        LocalSpark.world.copyTo(outlines.resolve("world.topojson"))
        data.resolve("paper/bastian.trigrid.json").copyTo(outlines.resolve("bastian.trigrid.json"))
        data.resolve("domains/lake.geojson").copyTo(outlines.resolve("more").createDirectories().resolve("lake.v2.geojson"))
        outlines.resolve("more/ünter: plate.wkt").writeText("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((3 0, 4 0, 4 1, 3 1, 3 0)))\n")
        outlines.resolve("bowtie.wkt").writeText("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\n")
        outlines.resolve("broken.geojson").writeText("{")
        outlines.resolve("plate.svg").writeText("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0 H4 V3 A2 2 0 0 1 0 3 Z\"/></svg>")
        outlines.resolve("notes.txt").writeText("no outline")
        return outlines
    }

    private fun files(folder: Path): Map<String, Path> = Files.walk(folder).use { all ->
        all.filter { it.isRegularFile() && !folder.relativize(it).startsWith("report") }.toList()
    }.associateBy { folder.relativize(it).toString() }

    @Test
    fun `the meshes are byte for byte those of the batch command`() {
        val outlines = outlines()
        val options = arrayOf("--format", "msh41", "--order", "2", "--sizes", "grade", "--size-source", "0.05@0.5,0.5")
        val outcome = run("--in", outlines, "--out", folder.resolve("spark"), "--elements-per-task", 20_000, "--strict", *options)
        assertEquals(ExitCodes.FILE_TROUBLE, outcome.code, outcome.err)
        assertEquals(ExitCodes.FILE_TROUBLE, batch("mesh", outlines, "--out-dir", folder.resolve("batch"), *options))
        val expected = files(folder.resolve("batch"))
        val found = files(folder.resolve("spark"))
        assertEquals(expected.keys, found.keys)
        assertEquals(404, found.size)
        for ((name, file) in found) assertArrayEquals(expected.getValue(name).readBytes(), file.readBytes(), name)
        val lines = Files.list(folder.resolve("spark/report")).use { all -> all.filter { it.name.endsWith(".json") }.toList() }
            .flatMap { it.readLines() }
        assertEquals(404, lines.count { "\"output\":" in it })
        assertEquals(12, lines.count { "\"error\":" in it })
        assertTrue(outcome.out.trim().endsWith("404 meshes of 7 files, ${elements(lines)} elements, 12 failed"), outcome.out)
    }

    private fun elements(lines: List<String>) =
        lines.sumOf { Regex("\"elements\":(\\d+)").find(it)?.groupValues?.get(1)?.toInt() ?: 0 }

    @Test
    fun `points, patterns and files by name`() {
        val points = folder.resolve("square.csv").also { it.writeText("0,0\n1,0\n1,1\n0,1\n") }
        folder.resolve("a.wkt").writeText("POLYGON ((0 0, 1 0, 0 1, 0 0))")
        folder.resolve("b.wkt").writeText("POLYGON ((0 0, 2 0, 0 1, 0 0))")
        val outcome = run("--in", points, "--in", folder.resolve("*.wkt"), "--out", folder.resolve("out"), "--spacing", "0.2")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals(setOf("a.msh", "b.msh", "square.msh"), files(folder.resolve("out")).keys)
    }

    @Test
    fun `a table of outlines becomes a table of meshes`() {
        val table = folder.resolve("parcels.csv")
        table.writeText(
            "parcel,shape,owner\n7,\"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\",A\n" +
                "8,\"{\"\"type\"\": \"\"Polygon\"\",\n\"\"coordinates\"\": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}\",B\n9,POLYGON,C\n",
        )
        val columns = arrayOf("--id-column", "parcel", "--outline-column", "shape")
        val outcome = run("--in", table, "--table", "csv", *columns, "--out", folder.resolve("out"), "--spacing", "0.25")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertTrue("2 meshes of 3 outlines" in outcome.out && "1 failed" in outcome.out, outcome.out)
        val meshes = LocalSpark.session().read().parquet(folder.resolve("out/meshes").toString()).orderBy("id").collectAsList()
        assertEquals(listOf("7", "8", "9"), meshes.map { it.getAs<String>("id") })
        assertEquals(3 * meshes[0].getAs<Int>("elements"), meshes[0].getList<Int>(meshes[0].fieldIndex("elementNodes")).size)
        assertEquals("FORMAT", meshes[2].getAs<String>("errorKind"))
        val files = run("--in", folder.resolve("out/meshes"), "--table", "parquet", "--outline-column", "name", "--out", folder.resolve("again"))
        assertTrue("0 meshes of 3 outlines" in files.out, files.out + files.err)
        val missing = run("--in", table, "--table", "csv", "--out", folder.resolve("out"))
        assertEquals(ExitCodes.USAGE, missing.code)
        assertTrue("no column id; it has parcel, shape, owner" in missing.err, missing.err)
    }

    @Test
    fun `what is asked wrongly is told before any work`() {
        val wkt = folder.resolve("a.wkt").also { it.writeText("POLYGON ((0 0, 1 0, 0 1, 0 0))") }
        val out = folder.resolve("out")
        fun check(code: Int, word: String, vararg arguments: Any) {
            val outcome = run(*arguments)
            assertEquals(code, outcome.code, outcome.err)
            assertTrue(word in outcome.err, outcome.err)
        }
        check(ExitCodes.USAGE, "--in", "--out", out)
        check(ExitCodes.USAGE, "several files", "--in", wkt, "--out", out, "--format", "triangle")
        check(ExitCodes.USAGE, "--order 2", "--in", wkt, "--out", out, "--format", "su2", "--order", "2")
        check(ExitCodes.USAGE, "gradation", "--in", wkt, "--out", out, "--gradation", "-1")
        check(ExitCodes.FILE_TROUBLE, "no such file", "--in", folder.resolve("none"), "--out", out)
        folder.resolve("a.geojson").writeText("{}")
        check(ExitCodes.USAGE, "would both", "--in", folder, "--out", out)
        assertTrue("--elements-per-task" in run("--help").out)
    }
}
