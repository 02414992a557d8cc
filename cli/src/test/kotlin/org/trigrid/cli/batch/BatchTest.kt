package org.trigrid.cli.batch

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.cli.Cancellation
import org.trigrid.cli.ExitCodes
import org.trigrid.cli.Outcome
import org.trigrid.cli.Samples
import org.trigrid.cli.Terminal
import org.trigrid.io.MeshFormats
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import kotlin.io.path.readBytes
import kotlin.io.path.readLines

class BatchTest {
    @TempDir
    lateinit var folder: Path

    private val meshes: Path get() = folder.resolve("meshes")
    private val report: Path get() = meshes.resolve("report.jsonl")

    /** Two good files, one of them in a folder of its own and with two domains, and two bad ones. */
    private fun outlines(): Path {
        val outlines = Files.createDirectories(folder.resolve("outlines"))
        Samples.plate(outlines)
        Samples.twoSquares(Files.createDirectories(outlines.resolve("more")))
        Samples.bowTie(outlines)
        Samples.file(outlines, "broken.geojson", "{")
        Samples.file(outlines, "notes.txt", "no outline")
        return outlines
    }

    private fun run(vararg more: String): Outcome =
        Outcome.of("mesh", outlines(), "--out-dir", meshes, "--spacing", "0.2", "--report", report, *more)

    private fun lines(): List<JsonObject> = report.readLines().map { Json.parseToJsonElement(it).jsonObject }

    private fun text(line: JsonObject, key: String) = line.getValue(key).jsonPrimitive.content

    @Test
    fun `bad files are told and the others meshed`() {
        val outcome = run()
        assertEquals(ExitCodes.FILE_TROUBLE, outcome.code)
        assertTrue(outcome.out.startsWith("$meshes: 3 meshes of 4 files, "), outcome.out)
        assertTrue("2 failed" in outcome.out)
        assertTrue(outcome.errorLines.any { "bowtie.wkt: DUPLICATE_NODE" in it }, outcome.err)
        for (name in listOf("plate.msh", "more/two-1.msh", "more/two-2.msh")) assertTrue(MeshFormats.read(meshes.resolve(name)).elementCount > 10)
        val failed = lines().filter { text(it, "status") == "failed" }
        assertEquals(setOf(ExitCodes.FILE_TROUBLE, ExitCodes.INVALID_DOMAIN), failed.map { it.getValue("code").jsonPrimitive.int }.toSet())
        assertTrue(failed.all { text(it, "error").isNotEmpty() })
        val done = lines().filter { text(it, "status") == "done" }
        assertEquals(3, done.size)
        for (line in done) {
            assertEquals(MeshFormats.read(Path.of(text(line, "output"))).elementCount, line.getValue("elements").jsonPrimitive.int)
        }
    }

    @Test
    fun `a faulty domain alone gives the code of faulty domains`() {
        val outcome = Outcome.of("mesh", Samples.bowTie(folder), Samples.plate(folder), "--out-dir", meshes)
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertTrue(Files.exists(meshes.resolve("plate.msh")))
    }

    @Test
    fun `the meshes are those of one file at a time, however many jobs`() {
        run("--jobs", "1")
        val one = meshes.resolve("more/two-2.msh").readBytes()
        run("--jobs", "4")
        assertArrayEquals(one, meshes.resolve("more/two-2.msh").readBytes())
        val single = folder.resolve("two.msh")
        Outcome.of("mesh", folder.resolve("outlines/more/two.wkt"), "-o", single, "--spacing", "0.2")
        assertArrayEquals(one, folder.resolve("two-2.msh").readBytes())
    }

    /** The outlines are not written again. */
    private fun resume(vararg more: String): Outcome =
        Outcome.of("mesh", folder.resolve("outlines"), "--out-dir", meshes, "--report", report, "--resume", *more)

    @Test
    fun `resuming leaves what was made of the same, and adds to the report`() {
        run()
        val plate = meshes.resolve("plate.msh")
        Files.delete(meshes.resolve("more/two-1.msh"))
        val before = Files.getLastModifiedTime(plate)
        val outcome = resume("--spacing", "0.2")
        assertTrue("1 meshes of 4 files" in outcome.out && "2 there already" in outcome.out, outcome.out)
        assertEquals(before, Files.getLastModifiedTime(plate))
        assertEquals(4, lines().count { text(it, "status") == "done" })
        // A file that is only touched is the same; a limit does not change a mesh.
        Files.setLastModifiedTime(folder.resolve("outlines/plate.wkt"), FileTime.fromMillis(System.currentTimeMillis() + 1_000_000))
        assertTrue("3 there already" in resume("--spacing", "0.2", "--max-elements", "1000").out)
    }

    @Test
    fun `resuming makes anew what other options or another input would make otherwise`() {
        run()
        for (options in listOf(arrayOf("--spacing", "0.1"), arrayOf("--spacing", "0.1", "--order", "2"), arrayOf("--spacing", "0.1", "--size-source", "0.05@0,0"))) {
            val outcome = resume(*options)
            assertTrue("3 meshes of 4 files" in outcome.out && "there already" !in outcome.out, outcome.out)
            assertTrue("3 there already" in resume(*options).out)
        }
        val finer = meshes.resolve("plate.msh").readBytes()
        // The report has that the coarse one was made too, but not last.
        assertTrue("3 meshes of 4 files" in resume("--spacing", "0.2").out)
        assertTrue(finer.size > meshes.resolve("plate.msh").readBytes().size)
        Samples.file(folder.resolve("outlines"), "plate.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
        assertTrue("1 meshes of 4 files" in resume("--spacing", "0.2").out)
        // Written by something else meanwhile.
        Files.setLastModifiedTime(meshes.resolve("plate.msh"), FileTime.fromMillis(1_000_000))
        assertTrue("1 meshes of 4 files" in resume("--spacing", "0.2").out)
    }

    @Test
    fun `resuming goes on from a report that was cut, and needs one`() {
        run()
        val text = report.readBytes()
        Files.write(report, text.copyOf(text.size - 20))
        resume("--spacing", "0.2")
        assertTrue("3 there already" in resume("--spacing", "0.2").out)
        val without = Outcome.of("mesh", folder.resolve("outlines"), "--out-dir", meshes, "--resume")
        assertEquals(ExitCodes.USAGE, without.code)
        assertTrue("--report" in without.err, without.err)
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", folder.resolve("outlines"), "--out-dir", meshes, "--resume", "--report", "-").code)
    }

    @Test
    fun `the countries of the world`() {
        val world = Path.of("..", "src-test-data", "world", "countries-110m.json")
        val outcome = Outcome.of("mesh", world, "--out-dir", meshes, "--report", report, "--jobs", "2", "--format", "msh41-binary")
        // Outlines that cross themselves at the 180th meridian, or where the file's rounding has moved a corner over an edge.
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertEquals(399, lines().count { text(it, "status") == "done" })
        assertEquals(
            setOf(
                "Antarctica_8", "Fiji_2", "North Korea_1", "Russia_10", "Russia_11", "Sudan", "land_122", "land_2", "land_3", "land_68",
            ),
            lines().filter { text(it, "status") == "failed" }.map { text(it, "name") }.toSet(),
        )
        for (line in lines().filter { text(it, "status") == "done" }) {
            assertEquals(emptyList<Any>(), org.trigrid.mesh.MeshCheck.check(MeshFormats.read(Path.of(text(line, "output")))), text(line, "name"))
        }
    }

    @Test
    fun `patterns, and files of one name`() {
        outlines()
        val outcome = Outcome.of("mesh", "$folder/outlines/**.wkt", "--out-dir", meshes, "--format", "vtu")
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertTrue(Files.exists(meshes.resolve("more/two-1.vtu")))
        val twice = Samples.file(folder, "plate.geojson", "{}")
        val clash = Outcome.of("mesh", twice, folder.resolve("outlines/plate.wkt"), "--out-dir", meshes)
        assertEquals(ExitCodes.USAGE, clash.code)
        assertTrue("would both" in clash.err, clash.err)
        assertEquals(ExitCodes.FILE_TROUBLE, Outcome.of("mesh", folder.resolve("none"), "--out-dir", meshes).code)
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", twice, "--out-dir", meshes, "--jobs", "0").code)
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", twice, "-o", folder.resolve("a.msh"), "--resume").code)
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", twice, folder.resolve("outlines/plate.wkt"), "-o", folder.resolve("a.msh")).code)
    }

    @Test
    fun `a cancelled batch says so and leaves whole files only`() {
        val cancellation = Cancellation().also { it.request() }
        val out = PrintStream(ByteArrayOutputStream())
        val arguments = arrayOf("mesh", outlines().toString(), "--out-dir", meshes.toString())
        val code = org.trigrid.cli.run(arguments, Terminal(out, out, showsProgress = false), cancellation)
        assertEquals(ExitCodes.CANCELLED, code)
        assertEquals(0, Files.list(meshes).use { it.count() })
    }

    @Test
    fun `the bar tells the rate and the time left`() {
        var now = 0L
        val err = ByteArrayOutputStream()
        val terminal = Terminal(PrintStream(ByteArrayOutputStream()), PrintStream(err, true), showsProgress = true)
        val progress = BatchProgress(terminal, 4) { now }
        now = 10_000_000_000
        progress.done(1.0, 100)
        assertEquals("\r[#######-----------------------]  25 % 1 meshes, 0.1/s, 0 failed, 30 s left\u001B[K", err.toString())
        progress.fail(0.5, "bad\n")
        assertTrue(err.toString().endsWith("\r\u001B[Kbad\n"))
        progress.skip(0.5)
        assertEquals(listOf(1, 1, 1), listOf(progress.meshes, progress.failed, progress.skipped))
    }
}
