package org.trigrid.cli

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.MeshCheck
import org.trigrid.project.DomainInputs
import java.nio.file.Files
import java.nio.file.Path

/** Commands that work on meshes and domains that are there. */
class ReworkCommandsTest {
    @TempDir
    lateinit var folder: Path

    private fun plateMesh(vararg more: String): Path {
        val file = folder.resolve("plate.msh")
        val outcome = Outcome.of("mesh", Samples.plate(folder), "-o", file, "--spacing", "0.1", *more)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        return file
    }

    @Test
    fun `a mesh is converted by the ending or by name`() {
        val mesh = plateMesh()
        val vtu = folder.resolve("plate.vtu")
        assertEquals(ExitCodes.DONE, Outcome.of("convert", mesh, vtu).code)
        val binary = folder.resolve("binary.msh")
        assertEquals(ExitCodes.DONE, Outcome.of("convert", vtu, binary, "--format", "msh41-binary").code)
        assertTrue(String(Files.readAllBytes(binary), Charsets.ISO_8859_1).startsWith("\$MeshFormat\n4.1 1 8\n"))
        val back = folder.resolve("back.msh")
        val direct = folder.resolve("direct.msh")
        Outcome.of("convert", binary, back)
        Outcome.of("convert", mesh, direct)
        assertEquals(Files.readString(direct), Files.readString(back))
        assertEquals(ExitCodes.DONE, Outcome.of("convert", mesh, folder.resolve("t.poly")).code)
        assertTrue(Files.exists(folder.resolve("t.ele")))
        assertEquals(ExitCodes.DONE, Outcome.of("info", folder.resolve("t.node")).code)
    }

    @Test
    fun `meshes of second order have their boundary on the curves of the project`() {
        val project = Samples.file(
            folder, "disc.trigrid.json",
            """{"format": "trigrid", "version": 1, "path": [{"type": "circle", "firstPoint": [1, 0], "centre": [0, 0], "spacing": 0.2, "name": "rim"}]}""",
        )
        val direct = folder.resolve("direct.msh")
        val outcome = Outcome.of("mesh", project, "-o", direct, "--order", "2", "--report", folder.resolve("r.json"))
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertTrue("second order" in outcome.out, outcome.out)
        assertTrue("\"straightenedEdges\": 0" in Files.readString(folder.resolve("r.json")))
        Outcome.of("mesh", project, "-o", folder.resolve("linear.msh"))
        val converted = folder.resolve("converted.msh")
        val conversion = Outcome.of("convert", folder.resolve("linear.msh"), converted, "--order", "2", "--project", project)
        assertEquals(ExitCodes.DONE, conversion.code, conversion.err)
        assertEquals(places(direct), places(converted))
        val many = Outcome.of("mesh", project, "--out-dir", folder.resolve("many"), "--order", "2")
        assertEquals(ExitCodes.DONE, many.code, many.err)
        assertEquals(Files.readString(direct), Files.readString(folder.resolve("many").resolve("disc.msh")))
    }

    /** Coordinates of the nodes of an MSH 2.2 file, whatever their numbers. */
    private fun places(file: Path): List<String> {
        val lines = Files.readAllLines(file)
        return lines.subList(lines.indexOf("\$Nodes") + 2, lines.indexOf("\$EndNodes")).map { it.substringAfter(' ') }.sorted()
    }

    @Test
    fun `an order that cannot be written is a usage error`() {
        val mesh = plateMesh()
        for (arguments in listOf(listOf("x.su2", "--order", "2"), listOf("x.msh", "--order", "3"), listOf("x.geojson", "--order", "2"))) {
            val more = arguments.drop(1).toTypedArray()
            val outcome = Outcome.of("convert", mesh, folder.resolve(arguments[0]), *more)
            assertEquals(ExitCodes.USAGE, outcome.code, outcome.err)
            assertTrue("--order" in outcome.err)
        }
        assertEquals(ExitCodes.USAGE, Outcome.of("convert", mesh, folder.resolve("x.msh"), "--project", mesh).code)
        assertEquals(ExitCodes.USAGE, Outcome.of("mesh", Samples.plate(folder), "-o", folder.resolve("x.csv"), "--order", "2").code)
    }

    @Test
    fun `a domain is converted, and so is the outline of a mesh`() {
        val outline = folder.resolve("outline.geojson")
        assertEquals(ExitCodes.DONE, Outcome.of("convert", plateMesh(), outline).code)
        val domain = DomainFormats.read(outline).single().domain
        assertEquals(2 - 0.04, domain.area, 1e-9)
        val project = folder.resolve("p.trigrid.json")
        val outcome = Outcome.of("convert", outline, project)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        assertEquals(domain.nodeCount, DomainInputs.read(project).single().domain.nodeCount)
        val svg = Samples.file(folder, "disc.svg", "<svg><circle cx='5' cy='5' r='2'/></svg>")
        Outcome.of("convert", svg, folder.resolve("disc.wkt"), "--spacing", "0.5")
        assertEquals(25, DomainFormats.read(folder.resolve("disc.wkt")).single().domain.nodeCount)
    }

    @Test
    fun `formats are listed, and what cannot be is a usage error`() {
        val list = Outcome.of("convert", "--list").out
        for (name in listOf("msh22", "vtu", "abaqus", "su2", "nastran", "geojson", "dxf", "svg")) assertTrue("  $name " in list, name)
        assertEquals(ExitCodes.USAGE, Outcome.of("convert", plateMesh(), folder.resolve("x.stl")).code)
        val toMesh = Outcome.of("convert", Samples.plate(folder), folder.resolve("x.msh"))
        assertEquals(ExitCodes.USAGE, toMesh.code)
        assertTrue("trigrid mesh" in toMesh.err)
        assertEquals(ExitCodes.USAGE, Outcome.of("convert").code)
        assertEquals(ExitCodes.FILE_TROUBLE, Outcome.of("convert", folder.resolve("no.msh"), folder.resolve("x.vtu")).code)
    }

    @Test
    fun `a mesh is renumbered, improved and refined`() {
        val mesh = plateMesh("--no-renumber", "--no-improve")
        val out = folder.resolve("out.vtu")
        val renumbered = Outcome.of("renumber", mesh, "-o", out)
        assertEquals(ExitCodes.DONE, renumbered.code, renumbered.err)
        assertTrue(MeshFormats.read(out).bandwidth < MeshFormats.read(mesh).bandwidth)
        assertEquals(ExitCodes.DONE, Outcome.of("renumber", mesh, "-o", out, "--numbering", "cuthill-mckee").code)
        assertEquals(ExitCodes.USAGE, Outcome.of("renumber", mesh, "-o", out, "--numbering", "sloan").code)
        val improved = Outcome.of("improve", mesh, "-o", out)
        assertEquals(ExitCodes.DONE, improved.code, improved.err)
        assertTrue("mean quality" in improved.out)
        assertEquals(emptyList<Any>(), MeshCheck.check(MeshFormats.read(out), MeshFormats.read(mesh).outline()))
        val refined = Outcome.of("refine", mesh, "-o", out, "--times", "2")
        assertEquals(ExitCodes.DONE, refined.code, refined.err)
        assertEquals(16 * MeshFormats.read(mesh).elementCount, MeshFormats.read(out).elementCount)
        assertEquals(ExitCodes.USAGE, Outcome.of("refine", mesh, "-o", out, "--times", "0").code)
    }

    @Test
    fun `refining by a project follows its curves`() {
        val project = Samples.file(
            folder, "disc.trigrid.json",
            """{"format": "trigrid", "version": 1, "path": [{"type": "circle", "centre": [0, 0], "radius": 1, "spacing": 0.3}]}""",
        )
        val mesh = folder.resolve("disc.msh")
        Outcome.of("mesh", project, "-o", mesh)
        val outcome = Outcome.of("refine", mesh, "-o", folder.resolve("fine.msh"), "--times", "3", "--project", project)
        assertEquals(ExitCodes.DONE, outcome.code, outcome.err)
        val fine = MeshFormats.read(folder.resolve("fine.msh"))
        assertEquals(Math.PI, fine.outline().area, 2e-3)
        val missing = Outcome.of("refine", mesh, "-o", folder.resolve("fine.msh"), "--project", folder.resolve("no.trigrid.json"))
        assertEquals(ExitCodes.FILE_TROUBLE, missing.code)
    }

    @Test
    fun `a broken mesh is not worked on`() {
        val folded = Samples.file(
            folder, "folded.msh",
            "\$MeshFormat\n2.2 0 8\n\$EndMeshFormat\n\$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n\$EndNodes\n" +
                "\$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 4\n\$EndElements\n",
        )
        for (command in listOf("renumber", "improve", "refine")) {
            val outcome = Outcome.of(command, folded, "-o", folder.resolve("x.msh"))
            assertEquals(ExitCodes.INVALID_DOMAIN, outcome.code, command)
            assertTrue(outcome.errorLines.first().startsWith("$folded: "), outcome.err)
            assertTrue(Files.notExists(folder.resolve("x.msh")))
        }
    }
}
