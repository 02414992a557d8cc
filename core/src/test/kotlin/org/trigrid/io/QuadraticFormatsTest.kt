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
import org.trigrid.domain.Domain
import org.trigrid.domain.Path
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import org.trigrid.project.ShapeMiddles
import org.trigrid.shape.Circle
import java.io.ByteArrayOutputStream
import java.nio.file.Files

/** Meshes of six-node triangles in files; the programs of users read them in `.ci/formats.py`. */
class QuadraticFormatsTest {
    @TempDir
    lateinit var folder: java.nio.file.Path

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

    /** A ring with curved edges, an embedded line and renumbered nodes. */
    private val ring: QuadraticMesh by lazy {
        val path = Path.of(Circle(0.0, 0.0, 2.0, 0.4).withName("outside"), Circle(0.0, 0.0, 1.0, 0.3).withName("inside"))
        MeshRework.secondOrder(MeshGenerator.generate(path.toDomain()).mesh, ShapeMiddles(path))
    }

    private val two = TriMesh.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), intArrayOf(0, 1, 2, 0, 2, 3))

    private val readable = MeshFormats.all().filter { it.highestOrder == 2 && it.canRead }

    @Test
    fun `what is written is read back`() {
        assertEquals(listOf("msh22", "msh41", "msh22-binary", "msh41-binary", "vtu", "medit"), readable.map { it.name })
        val domain = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), "rim").embed(doubleArrayOf(0.2, 0.2, 0.4, 0.2), "line").build()
        for (mesh in listOf(one, ring, QuadraticMesh.of(MeshGenerator.generate(domain).mesh))) {
            for (format in readable) {
                val file = folder.resolve("mesh" + format.endings[0])
                MeshFormats.write(mesh, file, format)
                val read = MeshFormats.readEither(file)
                val quadratic = read.quadratic!!
                assertEquals(2, read.order)
                assertArrayEquals(mesh.nodeCoordinates(), quadratic.nodeCoordinates(), format.name)
                assertArrayEquals(mesh.elementNodes(), quadratic.elementNodes(), format.name)
                assertEquals(mesh.boundaryEdgeCount, quadratic.boundaryEdgeCount)
                for (tag in mesh.tags) {
                    val named = if (format === MeshFormat.MEDIT) "ref_${mesh.tags.indexOf(tag) + 1}" else tag
                    assertArrayEquals(mesh.nodesOn(tag), quadratic.nodesOn(named), "${format.name} $tag")
                }
                assertEquals(emptyList<Any>(), MeshCheck.check(read.corners))
                assertTrue((0 until quadratic.elementCount).all { quadratic.leastJacobian(it) > 0 })
            }
        }
    }

    @Test
    fun `clockwise elements are turned, and nodes of no element left out`() {
        val text = text(MeshFormat.MSH_22).replace("4 9 2 3 1 1 2 3 4 5 6", "4 9 2 3 1 1 3 2 6 5 4")
            .replace("\$Nodes\n6\n", "\$Nodes\n7\n99 5 5 0\n")
        val read = MeshFormats.readEither(Files.writeString(folder.resolve("turned.msh"), text)).quadratic!!
        assertEquals(one.nodeCount, read.nodeCount)
        assertEquals(one.area(0), read.area(0))
        assertArrayEquals(one.nodesOn("low"), read.nodesOn("low"))
        for (k in 0..2) {
            val a = read.nodeOf(0, k)
            val b = read.nodeOf(0, (k + 1) % 3)
            assertEquals((one.x(a) + one.x(b)) / 2, read.x(read.nodeOf(0, 3 + k)))
        }
    }

    @Test
    fun `middles that fit nowhere are told with their place`() {
        fun fault(from: String, to: String): String {
            val out = ByteArrayOutputStream()
            MeshFormats.write(QuadraticMesh.of(two), out, MeshFormat.MSH_22)
            val text = out.toString(Charsets.UTF_8)
            assertTrue(from in text, text)
            val file = Files.writeString(folder.resolve("bad.msh"), text.replace(from, to))
            return assertThrows(FileFormatException::class.java) { MeshFormats.readEither(file) }.message!!
        }
        val elements = Regex("(?m)^\\d+ 9 2 \\d+ 1 .*$").findAll(
            ByteArrayOutputStream().also { MeshFormats.write(QuadraticMesh.of(two), it, MeshFormat.MSH_22) }.toString(),
        ).map { it.value }.toList()
        val words = elements[0].split(' ')
        assertTrue("something else too" in fault(elements[0], (words.dropLast(1) + words[5]).joinToString(" ")))
        assertTrue("three nodes and of six" in fault(elements[0], (listOf(words[0], "2") + words.subList(2, 8)).joinToString(" ")))
        assertTrue("the middle" in fault(elements[0], (words.subList(0, 8) + listOf(words[9], words[10], words[8])).joinToString(" ")))
    }
}
