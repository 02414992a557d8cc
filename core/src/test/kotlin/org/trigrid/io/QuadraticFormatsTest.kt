package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.MeshGenerator
import org.trigrid.MeshRework
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMeshFactory
import org.trigrid.project.ProjectFile
import org.trigrid.project.ShapeMiddles
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path

/** Meshes of six-node triangles in files; the programs of users read them in `.ci/formats.py`. */
class QuadraticFormatsTest {
    @TempDir
    lateinit var folder: Path

    private val one: QuadraticMesh = QuadraticMesh.of(
        TriMeshFactory.of(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 0.0, 1.0), intArrayOf(0, 1, 2), intArrayOf(0, 1), intArrayOf(0), listOf("low"), "steel"),
    ) { mesh, edge ->
        EdgeMiddles.STRAIGHT.middleOf(mesh, edge).also { if (mesh.tags[mesh.edgeTag(edge)] == "low") it[1] = -0.125 }
    }

    private fun text(format: MeshFormat): String {
        val out = ByteArrayOutputStream()
        MeshFormats.write(one, out, format)
        return out.toString(Charsets.ISO_8859_1)
    }

    @Test
    fun `Gmsh has elements of the types 8 and 9`() {
        val lines = text(MeshFormat.MSH_22).lines()
        assertTrue("4 1 -0.125 0" in lines)
        assertEquals(listOf("4", "1 8 2 1 1 1 2 4", "2 8 2 2 2 2 3 5", "3 8 2 2 2 3 1 6", "4 9 2 3 1 1 2 3 4 5 6"), section(lines, "Elements"))
        val newer = section(text(MeshFormat.MSH_41).lines(), "Elements")
        assertEquals(listOf("3 4 1 4", "1 1 8 1", "1 1 2 4", "1 2 8 2", "2 2 3 5", "3 3 1 6", "2 1 9 1", "4 1 2 3 4 5 6"), newer)
        assertTrue("1 0 -0.125 0 2 0 0 1 1 0" in section(text(MeshFormat.MSH_41).lines(), "Entities"))
    }

    private fun section(lines: List<String>, name: String) = lines.subList(lines.indexOf("\$$name") + 1, lines.indexOf("\$End$name"))

    @Test
    fun `Abaqus, Nastran and Medit have their own elements`() {
        val abaqus = text(MeshFormat.ABAQUS).lines()
        val at = abaqus.indexOf("*ELEMENT, TYPE=CPS6, ELSET=steel")
        assertEquals("1, 1, 2, 3, 4, 5, 6", abaqus[at + 1])
        assertEquals("1, 2, 4", abaqus[abaqus.indexOf("*NSET, NSET=low") + 1])
        assertEquals("1, S1", abaqus[abaqus.indexOf("*SURFACE, TYPE=ELEMENT, NAME=low") + 1])
        assertTrue("CTRIA6  1       1       1       2       3       4       5       6       " in text(MeshFormat.NASTRAN).lines())
        val medit = text(MeshFormat.MEDIT).lines()
        assertEquals("1 2 4 1", medit[medit.indexOf("EdgesP2") + 2])
        assertEquals("1 2 3 4 5 6 1", medit[medit.indexOf("TrianglesP2") + 2])
    }

    @Test
    fun `formats without such elements refuse, and write nothing`() {
        for (format in MeshFormats.all().filter { it.highestOrder == 1 }) {
            val file = folder.resolve("mesh" + format.endings[0])
            val error = assertThrows(IllegalArgumentException::class.java) { MeshFormats.write(one, file, format) }
            assertTrue(error.message!!.startsWith("${format.name} has no elements of six nodes; these have: msh22, "), error.message)
            for (written in format.filesOf(file)) assertFalse(Files.exists(written))
        }
        for (format in MeshFormats.all().filter { it.highestOrder == 2 }) {
            val file = folder.resolve("mesh" + format.endings[0])
            MeshFormats.write(one, file, format)
            if (!format.canRead) continue
            val error = assertThrows(FileFormatException::class.java) { MeshFormats.read(file) }
            assertTrue("six nodes" in error.message!!, error.message)
        }
    }

    @Test
    fun `meshes of six-node triangles come back to the bit, with curved middles, regions and points`() {
        val disc = Path.of("../src-test-data/regions/stator-slot.trigrid.json").let { ProjectFile.read(it) }
        val made = MeshGenerator.generate(disc.toDomain()).mesh
        val mesh = MeshRework.secondOrder(made, ShapeMiddles(disc.path))
        for (format in MeshFormats.all().filter { it.highestOrder == 2 && it.canRead }) {
            val file = folder.resolve("slot" + format.endings[0])
            MeshFormats.write(mesh, file, format)
            assertEquals(2, MeshFormats.orderOf(file))
            val back = MeshFormats.readSecondOrder(file)
            assertArrayEquals(mesh.nodeCoordinates(), back.nodeCoordinates(), 0.0, format.name)
            // MSH 4.1 has them region by region.
            assertEquals(elements(mesh), elements(back), format.name)
            assertEquals(mesh.boundaryEdgeCount, back.boundaryEdgeCount, format.name)
            assertEquals(mesh.taggedEdgeCount, back.taggedEdgeCount, format.name)
            if (format != MeshFormat.MEDIT) {
                for (tag in mesh.tags) assertArrayEquals(mesh.nodesOn(tag), back.nodesOn(tag), "${format.name} $tag")
                for (region in mesh.regions) assertEquals(area(mesh, region.name), area(back, region.name), 1e-9, format.name)
            }
            MeshFormats.write(back, file, format)
            assertArrayEquals(mesh.nodeCoordinates(), MeshFormats.readSecondOrder(file).nodeCoordinates(), 0.0)
        }
        val plain = folder.resolve("plain.msh")
        MeshFormats.write(made, plain)
        assertEquals(1, MeshFormats.orderOf(plain))
        assertTrue("six nodes" in assertThrows(FileFormatException::class.java) { MeshFormats.readSecondOrder(plain) }.message!!)
    }

    private fun elements(mesh: QuadraticMesh) = mesh.elementNodes().toList().chunked(6).map { nodes ->
        val first = (0..2).minByOrNull { nodes[it] }!!
        List(6) { nodes[it / 3 * 3 + (it + first) % 3] }
    }.toSet()

    private fun area(mesh: QuadraticMesh, region: String) =
        (0 until mesh.elementCount).filter { mesh.regions[mesh.regionOf(it)].name == region }.sumOf { mesh.area(it) }

    @Test
    fun `what is no mesh of six-node triangles is told`() {
        val text = text(MeshFormat.MSH_22)
        val file = folder.resolve("bad.msh")
        for ((from, to) in listOf(
            "4 1 -0.125 0" to "4 1 5 0",                       // the middle of an edge, beyond the opposite corner
            "4 9 2 3 1 1 2 3 4 5 6" to "4 9 2 3 1 1 2 3 4 5 5",
            "4 9 2 3 1 1 2 3 4 5 6" to "4 9 2 3 1 1 2 3 4 5 1",
            "1 8 2 1 1 1 2 4" to "1 8 2 1 1 1 2 5",
            "1 8 2 1 1 1 2 4" to "1 1 2 1 1 1 2",
        )) {
            Files.writeString(file, text.replace(from, to).also { assertTrue(it != text) { from } })
            assertThrows(FileFormatException::class.java, { MeshFormats.readSecondOrder(file) }, to)
        }
    }
}
