package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMeshFactory
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
            assertTrue("six nodes" in error.message!! || "TrianglesP2" in error.message!! || "type" in error.message!!, error.message)
        }
    }
}
