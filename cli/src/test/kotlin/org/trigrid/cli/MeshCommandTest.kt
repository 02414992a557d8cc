package org.trigrid.cli

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.quality.QualityReport
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText

class MeshCommandTest {
    @TempDir
    lateinit var folder: Path

    private val output: Path get() = folder.resolve("out.msh")

    @Test
    fun `the example of the README makes a valid mesh and one line of figures`() {
        val outcome = Outcome.of("mesh", Samples.lake, "-o", output)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals("", outcome.err)
        val mesh = meshOf(output)
        val line = outcome.out.trimEnd()
        assertTrue(line.startsWith("$output: ${mesh.nodeCount} nodes, ${mesh.elementCount} elements, "), line)
        assertEquals(1, line.lines().size)
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh, DomainFormats.read(Samples.lake).single().domain))
    }

    @Test
    fun `more elements than allowed are refused before meshing, with how many and how much memory`() {
        val outcome = Outcome.of("mesh", Samples.lake, "-o", output, "--max-elements", "50")
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertTrue(outcome.err.contains("elements and") && outcome.err.contains("--max-elements"), outcome.err)
        assertEquals(emptyList<String>(), folder.listDirectoryEntries().map { it.name })
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", Samples.lake, "-o", output, "--max-elements", "0").code)
    }

    @Test
    fun `the report on standard output stands alone and agrees with the mesh`() {
        val outcome = Outcome.of("mesh", Samples.lake, "-o", output, "--report", "-")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        val report = Json.parseToJsonElement(outcome.out).jsonObject
        val mesh = meshOf(output)
        val quality = QualityReport.of(mesh)
        assertEquals(mesh.nodeCount, report.int("nodes"))
        assertEquals(mesh.elementCount, report.int("elements"))
        assertEquals(229, report.int("boundaryNodes"))
        assertEquals(5, report.int("loops"))
        assertEquals(mesh.bandwidth, report.part("bandwidth").int("after"))
        assertTrue(report.part("bandwidth").int("before") > report.part("bandwidth").int("after"))
        assertTrue(report.part("profile").int("before") > report.part("profile").int("after"))
        assertEquals(quality.minQuality, report.part("quality").double("min"), 1e-12)
        assertEquals(quality.minAngle, report.part("quality").double("minAngle"), 1e-9)
        assertEquals(mesh.elementCount, report.part("quality").getValue("histogram").jsonArray.sumOf { it.jsonPrimitive.int })
        val seconds = report.part("seconds")
        assertTrue(seconds.double("total") >= seconds.double("read") + seconds.double("front") + seconds.double("write"))
    }

    @Test
    fun `the manual documents every key of the report`() {
        val outcome = Outcome.of("mesh", Samples.lake, "-o", output, "--report", "-")
        val manual = Path.of("..", "docs", "cli.md").readText()
        for ((key, value) in Json.parseToJsonElement(outcome.out).jsonObject) {
            if (value !is JsonObject) assertTrue("`$key`" in manual, key)
            else for (part in value.keys) assertTrue("`$key.$part`" in manual || "`.$part`" in manual, "$key.$part")
        }
    }

    @Test
    fun `report and picture go to their files`() {
        val outcome = Outcome.of(
            "mesh", Samples.plate(folder), "-o", output, "--spacing", "0.1",
            "--report", folder.resolve("r.json"), "--picture", folder.resolve("p.svg"),
        )
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals(listOf("out.msh", "p.svg", "plate.wkt", "r.json"), names())
        assertEquals(meshOf(output).nodeCount, Json.parseToJsonElement(folder.resolve("r.json").readText()).jsonObject.int("nodes"))
        assertTrue("<svg" in folder.resolve("p.svg").readText())
    }

    @Test
    fun `both formats hold the same mesh`() {
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", Samples.lake, "-o", output).code)
        val other = folder.resolve("new.msh")
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", Samples.lake, "-o", other, "--format", "4.1").code)
        assertTrue(output.readText().startsWith("\$MeshFormat\n2.2 0 8\n"))
        assertTrue(other.readText().startsWith("\$MeshFormat\n4.1 0 8\n"))
        assertArrayEquals(meshOf(output).nodeCoordinates(), meshOf(other).nodeCoordinates())
        assertArrayEquals(meshOf(output).elementNodes(), meshOf(other).elementNodes())
    }

    @Test
    fun `nodes of a polygon file are kept unless a spacing is asked for`() {
        val plate = Samples.plate(folder)
        assertEquals(8, boundaryNodes(plate))
        assertEquals(2 * (20 + 10) + 4 * 2, boundaryNodes(plate, "--spacing", "0.1"))
    }

    @Test
    fun `options of the front are heard`() {
        val plate = Samples.plate(folder)
        fun elements(vararg options: String): Int {
            assertEquals(ExitCodes.DONE, Outcome.of("mesh", plate, "-o", output, "--spacing", "0.1", *options).code)
            return meshOf(output).elementCount
        }
        val usual = elements()
        assertTrue(elements("--max-size", "0.04") > 2 * usual)
        assertTrue(elements("--size-source", "0.01@1.5,0.5") > 1.3 * usual)
        assertTrue(elements("--size-source", "0.02@1.2,0.5,1.8,0.5", "--size-source=0.02@1.5,0.2,1.5,0.8") > 2 * usual)
        assertTrue(elements("--strategy", "classic") > 0)
        assertTrue(elements("--sizes", "grade", "--gradation", "0.4") > 0)
        assertTrue(elements("--no-improve", "--no-renumber") > 0)
    }

    @Test
    fun `the same input makes the same bytes`() {
        val again = folder.resolve("again.msh")
        Outcome.of("mesh", Samples.lake, "-o", output)
        Outcome.of("mesh", Samples.lake, "-o", again)
        assertArrayEquals(output.readBytes(), again.readBytes())
    }

    @Test
    fun `several polygons make several meshes and a report of several`() {
        val outcome = Outcome.of("mesh", Samples.twoSquares(folder), "-o", output, "--report", "-")
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals(listOf("out-1.msh", "out-2.msh", "two.wkt"), names())
        assertEquals(2, Json.parseToJsonElement(outcome.out).jsonArray.size)
    }

    @Test
    fun `a faulty domain is told fault by fault and the old file stays`() {
        output.writeText("old")
        val input = Samples.bowTie(folder)
        val outcome = Outcome.of("mesh", input, "-o", output)
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertEquals("", outcome.out)
        assertTrue(outcome.errorLines.any { it.startsWith("$input: CROSSING at (1.0, 1.0), nodes ") }, outcome.err)
        assertEquals("old", output.readText())
        assertEquals(listOf("bowtie.wkt", "out.msh"), names())
    }

    @Test
    fun `more elements than allowed are refused in one line`() {
        val outcome = Outcome.of("mesh", Samples.plate(folder), "-o", output, "--spacing", "1e-4")
        assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code)
        assertEquals(1, outcome.errorLines.size, outcome.err)
        assertTrue("elements" in outcome.err, outcome.err)
    }

    @Test
    fun `file trouble has its own code and names the file`() {
        val missing = folder.resolve("missing.wkt")
        val noInput = Outcome.of("mesh", missing, "-o", output)
        assertEquals(ExitCodes.FILE_TROUBLE, noInput.code)
        assertEquals(listOf("$missing: no such file or folder"), noInput.errorLines)

        val noFolder = Outcome.of("mesh", Samples.lake, "-o", folder.resolve("no/out.msh"))
        assertEquals(ExitCodes.FILE_TROUBLE, noFolder.code)
        assertEquals(listOf("${folder.resolve("no")}: no such file or folder"), noFolder.errorLines)

        val broken = Samples.file(folder, "broken.wkt", "POLYGON ((0 0, 1 0,\n1 x, 0 0))")
        val unreadable = Outcome.of("mesh", broken, "-o", output)
        assertEquals(ExitCodes.FILE_TROUBLE, unreadable.code)
        assertTrue(unreadable.errorLines.single().startsWith("$broken:2:"), unreadable.err)
    }

    @Test
    fun `a cancelled run leaves no file`() {
        val err = ByteArrayOutputStream()
        val stream = PrintStream(err, true, Charsets.UTF_8)
        val cancellation = Cancellation().also { it.request() }
        val arguments = arrayOf("mesh", Samples.lake.toString(), "-o", output.toString())
        assertEquals(ExitCodes.CANCELLED, run(arguments, Terminal(stream, stream, showsProgress = false), cancellation))
        assertEquals("${Samples.lake}: cancelled\n", err.toString(Charsets.UTF_8).replace("\r\n", "\n"))
        assertEquals(emptyList<String>(), names())
    }

    private fun boundaryNodes(input: Path, vararg options: String): Int {
        assertEquals(ExitCodes.DONE, Outcome.of("mesh", input, "-o", output, *options).code)
        return meshOf(output).boundaryEdgeCount
    }

    private fun meshOf(file: Path): TriMesh = MeshFormats.read(file)

    private fun names(): List<String> = folder.listDirectoryEntries().map { it.name }.sorted()

    private fun JsonObject.part(key: String): JsonObject = getValue(key).jsonObject

    private fun JsonObject.int(key: String): Int = getValue(key).jsonPrimitive.int

    private fun JsonObject.double(key: String): Double = getValue(key).jsonPrimitive.double
}
