package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.domain.DomainCheck
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random

/** Formats that are written only. */
class MeshWritersTest {
    @TempDir
    lateinit var folder: Path

    private val two: TriMesh = TriMeshFactory.of(
        doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1 / 3.0), intArrayOf(0, 1, 2, 0, 2, 3),
        intArrayOf(0, 1, 2, 3, 0, 2), intArrayOf(0, 1, 2), listOf("1 low", "LOW", "low"), "steel",
    )

    private fun text(mesh: TriMesh, format: MeshFormat): String {
        val out = ByteArrayOutputStream()
        MeshFormats.write(mesh, out, format)
        return out.toString(Charsets.UTF_8)
    }

    @Test
    fun `Abaqus has sets and surfaces by tag, told apart without case`() {
        assertEquals(
            """
            *HEADING
            mesh of TriGrid
            *NODE, NSET=Nall
            1, 0, 0, 0
            2, 1, 0, 0
            3, 1, 1, 0
            4, 0, 0.3333333333333333, 0
            *ELEMENT, TYPE=CPS3, ELSET=steel
            1, 1, 2, 3
            2, 1, 3, 4
            *NSET, NSET=g_1_low
            1, 2
            *ELSET, ELSET=g_1_low_elements
            1
            *SURFACE, TYPE=ELEMENT, NAME=g_1_low
            1, S1
            *NSET, NSET=LOW
            3, 4
            *ELSET, ELSET=LOW_elements
            2
            *SURFACE, TYPE=ELEMENT, NAME=LOW
            2, S2
            *NSET, NSET=low_2
            1, 3
            *ELSET, ELSET=low_2_elements
            2
            *NSET, NSET=boundary
            1, 2, 3, 4
            *ELSET, ELSET=boundary_elements
            1, 2
            *SURFACE, TYPE=ELEMENT, NAME=boundary
            1, S2
            2, S3
            """.trimIndent() + "\n",
            text(two, MeshFormat.ABAQUS),
        )
    }

    @Test
    fun `sets of Abaqus have names of their own`() {
        val mesh = TriMeshFactory.of(
            doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0), intArrayOf(0, 1, 2), intArrayOf(0, 1, 1, 2), intArrayOf(0, 1), listOf("nall", "a"), "A_elements",
        )
        val lines = text(mesh, MeshFormat.ABAQUS).lines()
        for (line in listOf("*NODE, NSET=Nall", "*NSET, NSET=nall_2", "*ELEMENT, TYPE=CPS3, ELSET=A_elements", "*ELSET, ELSET=a_elements_2")) {
            assertTrue(line in lines, "$line in $lines")
        }
    }

    @Test
    fun `SU2 has a marker for each tag of the boundary and none for embedded edges`() {
        val lines = text(two, MeshFormat.SU2).lines()
        assertEquals(listOf("NDIME= 2", "NELEM= 2", "5 0 1 2 0", "5 0 2 3 1", "NPOIN= 4", "0 0 0"), lines.take(6))
        assertEquals("NMARK= 3", lines[9])
        assertEquals(listOf("MARKER_TAG= 1_low", "MARKER_ELEMS= 1", "3 0 1"), lines.subList(10, 13))
    }

    @Test
    fun `Nastran has fixed fields`() {
        val lines = text(two, MeshFormat.NASTRAN).lines()
        val grid = lines.indexOfFirst { it.startsWith("GRID*   4") }
        assertEquals("GRID*   4                                             0..333333333333333", lines[grid])
        assertEquals("*                     0.", lines[grid + 1])
        assertTrue("CTRIA3  2       1       1       3       4       " in lines)
        assertTrue("SET1    1       1       2       " in lines)
        val many = text(GridMeshes.grid(9, 9).mesh, MeshFormat.NASTRAN).lines().filter { it.startsWith("SET1") || it.startsWith("+") }
        assertTrue(many.all { it.length <= 72 }, many.toString())
    }

    @Test
    fun `tables and JSON`() {
        MeshFormats.write(two, folder.resolve("m.csv"))
        assertEquals("node,x,y\n0,0,0\n1,1,0\n2,1,1\n3,0,0.3333333333333333\n", Files.readString(folder.resolve("m.nodes.csv")))
        assertEquals("element,a,b,c,region\n0,0,1,2,steel\n1,0,2,3,steel\n", Files.readString(folder.resolve("m.elements.csv")))
        assertTrue(Files.readString(folder.resolve("m.edges.csv")).endsWith("0,2,low,1\n"))
        val json = kotlinx.serialization.json.Json.parseToJsonElement(text(two, MeshFormat.JSON)).toString()
        assertTrue("\"1 low\":[[0,1]]" in json, json)
        assertTrue("\"elements\":[[0,1,2],[0,2,3]]" in json, json)
        assertThrows(IllegalArgumentException::class.java) { text(two, MeshFormat.CSV) }
    }

    @Test
    fun `a mesh with a hole is a domain of Triangle's`() {
        val mesh = GridMeshes.grid(7, 7) { i, j -> i in 2..3 && j in 2..4 }.mesh
        MeshFormats.write(mesh, folder.resolve("g.poly"), MeshFormat.TRIANGLE)
        val domain = DomainFormats.read(folder.resolve("g.poly")).single().domain
        assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        assertEquals(2, domain.loopCount)
        assertEquals(mesh.outline().area, domain.area)
        assertEquals((0 until mesh.elementCount).sumOf { mesh.area(it) }, domain.area, 1e-12)
    }

    @Test
    fun `decimals fit their fields and lose no more than the last digit`() {
        val random = Random(5)
        val decimal = DecimalText()
        repeat(20_000) {
            val value = if (it % 2 == 0) random.nextGaussian() * 100 else Double.fromBits(random.nextLong())
            if (!value.isFinite()) return@repeat
            assertEquals(value, decimal.shortest(value).toDouble())
            val abaqus = decimal.fitting(value, 20)
            assertTrue(abaqus.length <= 20, abaqus)
            assertEquals(value, abaqus.toDouble(), Math.abs(value) * 1e-12)
            val nastran = decimal.nastran(value, 16)
            assertTrue(nastran.length <= 16 && '.' in nastran && 'e' !in nastran, nastran)
            val plain = nastran.replace(Regex("(?<=[0-9.])([+-])"), "e$1")
            assertEquals(value, plain.toDouble(), Math.abs(value) * 1e-9)
            if (Math.abs(value) in 1e-1..1e6) assertEquals(value, plain.toDouble(), Math.abs(value) * 1e-13)
        }
        assertEquals("-.333333333333333", decimal.nastran(-1 / 3.0, 17))
        assertEquals("12.", decimal.nastran(12.0, 16))
        assertEquals("1.5-9", decimal.nastran(1.5e-9, 16))
        assertEquals("1.+20", decimal.nastran(1e20, 16))
    }
}
