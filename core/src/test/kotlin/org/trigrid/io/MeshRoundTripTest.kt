package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path

class MeshRoundTripTest {
    @TempDir
    lateinit var folder: Path

    /** With a hole, several tags and an embedded edge. */
    private fun sample(seed: Long): TriMesh {
        val grid = GridMeshes.shaken(9, 8, seed) { i, j -> i == 4 && j in 3..4 }.mesh
        val edges = grid.edgeNodes()
        val inner = (0 until grid.edgeCount).first { e ->
            (0..1).all { grid.kindOf(edges[2 * e + it]).name == "INTERIOR" }
        }
        return TriMeshFactory.of(
            grid.xy, grid.elements, grid.edges + intArrayOf(edges[2 * inner], edges[2 * inner + 1]), grid.edgeTags + grid.tags.size,
            grid.tags + "rib", "plate",
        )
    }

    @Test
    fun `what can be read keeps nodes, elements and groups`() {
        for (format in MeshFormats.all().filter { it.canRead }) {
            for (seed in 1L..4L) {
                val mesh = sample(seed)
                val file = folder.resolve("mesh${format.endings[0]}")
                MeshFormats.write(mesh, file, format)
                val back = MeshFormats.read(file)
                assertArrayEquals(mesh.xy, back.xy, format.name)
                assertArrayEquals(mesh.elements, back.elements, format.name)
                assertEquals(emptyList<Any>(), MeshCheck.check(back), format.name)
                assertEquals(groups(mesh), groups(back), format.name)
            }
        }
    }

    @Test
    fun `formats with names keep them`() {
        val mesh = sample(1)
        for (format in listOf(MeshFormat.MSH_22, MeshFormat.MSH_41, MeshFormat.MSH_22_BINARY, MeshFormat.MSH_41_BINARY, MeshFormat.VTU)) {
            val file = folder.resolve("named${format.endings[0]}")
            MeshFormats.write(mesh, file, format)
            val back = MeshFormats.read(file)
            assertEquals(mesh.tags.toSet(), back.tags.toSet(), format.name)
            assertEquals("plate", back.regionName, format.name)
            assertArrayEquals(mesh.nodesOn("rib"), back.nodesOn("rib"))
        }
    }

    /** Tagged edges, grouped, whatever the groups are called. */
    private fun groups(mesh: TriMesh): Set<Set<Set<Int>>> = (0 until mesh.taggedEdgeCount)
        .groupBy({ mesh.edgeTag(it) }, { setOf(mesh.edgeStart(it), mesh.edgeEnd(it)) }).values.map { it.toSet() }.toSet()

    @Test
    fun `binary Gmsh files of the other byte order are read`() {
        val mesh = sample(2)
        val out = ByteArrayOutputStream()
        MeshFormats.write(mesh, out, MeshFormat.MSH_22_BINARY)
        val big = BigEndian.msh22(out.toByteArray())
        assertArrayEquals(mesh.xy, MshReader.read(big, "big").corners.xy)
    }

    @Test
    fun `VTU is read in every coding`() {
        val ascii = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="3"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0  1 1 0  0 1e0 0</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 2 3 0 1</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5 5 3</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"""
        assertEquals(2, VtuReader.read(ascii.toByteArray(), "a.vtu").corners.elementCount)
        // Written by meshio 5.3.5: base64, compressed by zlib.
        val zlib = Files.readAllBytes(Path.of("..", "src-test-data", "meshes", "two-zlib.vtu"))
        val mesh = VtuReader.read(zlib, "b.vtu").corners
        assertArrayEquals(intArrayOf(0, 1, 2, 0, 2, 3), mesh.elements)
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.1), mesh.xy)
        val plain = Files.readAllBytes(Path.of("..", "src-test-data", "meshes", "two-base64.vtu"))
        assertArrayEquals(mesh.xy, VtuReader.read(plain, "c.vtu").corners.xy)
    }

    @Test
    fun `faults are named with their lines`() {
        fun fault(read: () -> Unit): FileFormatException = assertThrows(FileFormatException::class.java) { read() }
        val medit = "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 x 0\nEnd\n"
        assertEquals(6, fault { MeditReader.read(medit.toByteArray(), "m.mesh") }.line)
        val quads = "MeshVersionFormatted 1 Dimension 3\n# none\nVertices 1 0 0 0 0\nQuadrilaterals 1 1 1 1 1 0\n"
        assertTrue("Quadrilaterals" in fault { MeditReader.read(quads.toByteArray(), "m.mesh") }.message!!)
        val vtu = "<VTKFile type=\"UnstructuredGrid\">\n<Piece>\n<Points></Piece></VTKFile>"
        assertEquals(3, fault { VtuReader.read(vtu.toByteArray(), "v.vtu") }.line)
        Files.writeString(folder.resolve("t.node"), "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n")
        Files.writeString(folder.resolve("t.ele"), "1 3 0\n\n1 1 2 4\n")
        val triangle = fault { MeshFormats.read(folder.resolve("t.ele")) }
        assertEquals(3, triangle.line)
        assertTrue(triangle.source.endsWith("t.ele"))
    }

    @Test
    fun `Triangle's own files are read`() {
        Files.writeString(folder.resolve("t.node"), "# Generated by triangle\n4 2 0 1\n0 0 0 1\n1 1 0 1\n2 1 1 0\n3 0 1 5\n")
        Files.writeString(folder.resolve("t.ele"), "2  3  1\n0 0 1 2 7.0\n1 0 2 3 7.0\n")
        Files.writeString(folder.resolve("t.edge"), "5 1\n0 0 1 3\n1 1 2 1\n2 2 3 1\n3 3 0 1\n4 0 2 0\n")
        val mesh = MeshFormats.read(folder.resolve("t.node"))
        assertEquals("region_7", mesh.regionName)
        assertArrayEquals(intArrayOf(0, 1), mesh.nodesOn("marker_3"))
        assertEquals(4, mesh.taggedEdgeCount)
    }

    @Test
    fun `formats are found by name and ending`() {
        assertSame(MeshFormat.MSH_41, MeshFormats.named("4.1"))
        assertSame(MeshFormat.VTU, MeshFormats.named("VTU"))
        assertNull(MeshFormats.named("stl"))
        assertSame(MeshFormat.MSH_22, MeshFormats.forWriting(Path.of("a.MSH")))
        assertSame(MeshFormat.ABAQUS, MeshFormats.forWriting(Path.of("a.b.inp")))
        assertSame(MeshFormat.CSV, MeshFormats.forWriting(Path.of("a.csv")))
        assertNull(MeshFormats.forReading(Path.of("a.inp")))
        assertNull(MeshFormats.forReading(Path.of("a.poly")))
        assertSame(MeshFormat.TRIANGLE, MeshFormats.forReading(Path.of("a.ele")))
        val names = MeshFormats.all().map { it.name } + DomainFormats.all().map { it.name }
        assertTrue(names.all { Regex("[a-z0-9-]+").matches(it) })
    }
}

/** Turns the numbers of a binary MSH 2.2 file round. */
private object BigEndian {
    fun msh22(little: ByteArray): ByteArray {
        val bytes = little.copyOf()
        val buffer = java.nio.ByteBuffer.wrap(bytes).order(java.nio.ByteOrder.LITTLE_ENDIAN)
        val text = String(little, Charsets.ISO_8859_1)
        turn(bytes, text.indexOf('\n', text.indexOf("2.2 1 8")) + 1, 4)
        var at = afterCount(text, "\$Nodes\n")
        val nodes = text.substring(text.indexOf("\$Nodes\n") + 7, at - 1).toInt()
        repeat(nodes) {
            turn(bytes, at, 4)
            for (k in 0..2) turn(bytes, at + 4 + 8 * k, 8)
            at += 28
        }
        at = afterCount(text, "\$Elements\n")
        val end = text.indexOf("\n\$EndElements")
        while (at < end) {
            buffer.getInt(at)
            turn(bytes, at, 4)
            at += 4
        }
        return bytes
    }

    private fun afterCount(text: String, section: String) = text.indexOf('\n', text.indexOf(section) + section.length) + 1

    private fun turn(bytes: ByteArray, at: Int, size: Int) = bytes.reverse(at, at + size)
}
