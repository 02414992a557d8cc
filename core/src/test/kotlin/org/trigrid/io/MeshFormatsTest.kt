package org.trigrid.io

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.NodeKind
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path

class MeshFormatsTest {
    @TempDir
    lateinit var folder: Path

    private fun text(mesh: TriMesh, format: MeshFormat): String {
        val out = ByteArrayOutputStream()
        MeshFormats.write(mesh, out, format)
        return out.toString(Charsets.US_ASCII)
    }

    private fun read(text: String): TriMesh = MshReader.read(text.toByteArray(), "test.msh").corners

    @Test
    fun `a round trip keeps every bit`() {
        for (seed in 1L..10L) {
            val grid = GridMeshes.shaken(9, 8, seed) { i, j -> i == 4 && j in 3..4 }
            val inner = (0 until grid.mesh.nodeCount).filter { grid.mesh.kindOf(it) == NodeKind.INTERIOR }
            val (a, b) = inner.firstNotNullOf { n -> neighbour(grid.mesh, n)?.let { n to it } }
            val mesh = TriMeshFactory.of(
                grid.mesh.xy, grid.mesh.elements, grid.mesh.edges + intArrayOf(a, b), grid.mesh.edgeTags + 2,
                grid.mesh.tags + "a (rib) \"x\"", "plate",
            )
            for (format in listOf(MeshFormat.MSH_22, MeshFormat.MSH_41)) {
                val file = folder.resolve("mesh-$seed.msh")
                MeshFormats.write(mesh, file, format)
                val back = MeshFormats.read(file)
                assertArrayEquals(mesh.xy, back.xy)
                assertArrayEquals(mesh.elements, back.elements)
                assertArrayEquals(mesh.neighbours, back.neighbours)
                assertArrayEquals(mesh.kinds, back.kinds)
                assertEquals(named(mesh), named(back))
                assertEquals("plate", back.regionName)
                assertEquals(emptyList<Any>(), MeshCheck.check(back))
                assertEquals(text(mesh, format), text(back, format))
            }
        }
    }

    private fun neighbour(mesh: TriMesh, node: Int): Int? =
        (0 until mesh.edgeCount).map { mesh.edgeNodes()[2 * it] to mesh.edgeNodes()[2 * it + 1] }
            .firstOrNull { (p, q) -> p == node && mesh.kindOf(q) == NodeKind.INTERIOR }?.second

    private fun named(mesh: TriMesh): Set<Triple<Int, Int, String>> = (0 until mesh.taggedEdgeCount).map {
        Triple(mesh.edgeStart(it), mesh.edgeEnd(it), mesh.tags[mesh.edgeTag(it)].replace('"', '_').replace('(', '_').replace(')', '_'))
    }.toSet()

    @Test
    fun `one element in full`() {
        val mesh = TriMeshFactory.of(
            doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 0.1), intArrayOf(0, 1, 2), intArrayOf(0, 1), intArrayOf(0), listOf("base", "unused"), "base",
        )
        assertEquals(
            """
            |${'$'}MeshFormat
            |2.2 0 8
            |${'$'}EndMeshFormat
            |${'$'}PhysicalNames
            |3
            |1 1 "base"
            |1 2 "boundary"
            |2 3 "base_2"
            |${'$'}EndPhysicalNames
            |${'$'}Nodes
            |3
            |1 0 0 0
            |2 1 0 0
            |3 0 0.1 0
            |${'$'}EndNodes
            |${'$'}Elements
            |4
            |1 1 2 1 1 1 2
            |2 1 2 2 2 2 3
            |3 1 2 2 2 3 1
            |4 2 2 3 1 1 2 3
            |${'$'}EndElements
            |
            """.trimMargin(),
            text(mesh, MeshFormat.MSH_22),
        )
        val lines = text(mesh, MeshFormat.MSH_41).lines()
        assertEquals(
            listOf("\$Entities", "0 2 1 0", "1 0 0 0 1 0 0 1 1 0", "2 0 0 0 1 0.1 0 1 2 0", "1 0 0 0 1 0.1 0 1 3 2 1 2", "\$EndEntities"),
            lines.subList(lines.indexOf("\$Entities"), lines.indexOf("\$EndEntities") + 1),
        )
    }

    @Test
    fun `what others write is read`() {
        val mesh = read(
            """
            ${'$'}MeshFormat
            2.2 0 8
            ${'$'}EndMeshFormat
            ${'$'}Comments
            ${'$'}Nodes are not here
            ${'$'}EndComments
            ${'$'}Nodes
            5
            10 0 0 0
            70000000 1.0 0e0 0
            30 +0 1 -0
            40 1 1 0.0
            99 7 7 0
            ${'$'}EndNodes
            ${'$'}Elements
            5
            1 15 2 0 1 99
            2 1 2 7 1 70000000 10
            3 2 3 4 1 0 10 70000000 30
            4 2 2 4 1 70000000 30 40
            5 1 0 40 30
            ${'$'}EndElements
            """.trimIndent().replace("\n", "\r\n"),
        )
        assertEquals(4, mesh.nodeCount)
        assertEquals(emptyList<Any>(), MeshCheck.check(mesh))
        assertArrayEquals(intArrayOf(0, 1), mesh.nodesOn("curve 7"))
        assertArrayEquals(intArrayOf(0, 1, 2, 3), mesh.nodesOn("boundary"))
        assertEquals("surface 4", mesh.regionName)
        // The second triangle was clockwise.
        assertArrayEquals(intArrayOf(0, 1, 2, 1, 3, 2), mesh.elementNodes())
    }

    @Test
    fun `numbers are read exactly`() {
        val random = java.util.Random(8)
        repeat(20_000) {
            val value = if (it % 2 == 0) random.nextInt() / 1e5 else Double.fromBits(random.nextLong())
            if (!value.isFinite()) return@repeat
            assertEquals(value, MshScanner(" $value\n".toByteArray(), "").double("x"))
        }
        assertEquals(9007199254740993.0, MshScanner("9007199254740993".toByteArray(), "").double("x"))
    }

    @Test
    fun `a fault is named with its line and column`() {
        val good = text(GridMeshes.grid(1, 1).mesh, MeshFormat.MSH_22)
        fun faultOf(text: String): FileFormatException =
            assertThrows(FileFormatException::class.java) { read(text) }
        val bad = faultOf(good.replace("2 1 0 0\n", "2 1 O 0\n"))
        assertEquals("test.msh", bad.source)
        assertEquals(13, bad.line)
        assertEquals(5, bad.column)
        assertTrue("'O'" in bad.message!!, bad.message)
        assertTrue("no node with the id 9" in faultOf(good.replace("1 2 3\n", "1 2 9\n")).message!!)
        assertTrue("ends" in faultOf(good.substring(0, good.length - 20)).message!!)
        assertTrue("binary" in faultOf(good.replace("2.2 0 8", "2.2 1 8")).message!!)
        assertTrue("4.0" in faultOf(good.replace("2.2 0 8", "4.0 0 8")).message!!)
        assertTrue("type 3" in faultOf(good.replace(" 2 2 3 1 ", " 3 2 3 1 ")).message!!)
        assertTrue("z = 1" in faultOf(good.replace("2 1 0 0\n", "2 1 0 1\n")).message!!)
        assertTrue("twice" in faultOf(good.replace("2 1 0 0\n", "3 1 0 0\n")).message!!)
        assertTrue("finite" in faultOf(good.replace("2 1 0 0\n", "2 NaN 0 0\n")).message!!)
        assertTrue("whole number" in faultOf(good.replace("\$Nodes\n4", "\$Nodes\n4.5")).message!!)
        assertTrue("2000000000" in faultOf(good.replace("\$Nodes\n4", "\$Nodes\n2000000000")).message!!)
        assertTrue("empty" in faultOf("").message!!)
        assertTrue("MeshFormat" in faultOf("solid cube").message!!)
    }

    @Test
    fun `every cut or changed file is read or refused, never more`() {
        val random = java.util.Random(3)
        for (format in listOf(MeshFormat.MSH_22, MeshFormat.MSH_41)) {
            val good = text(GridMeshes.shaken(3, 3, 1L).mesh, format).toByteArray()
            repeat(1500) {
                val bytes = if (it % 2 == 0) good.copyOf(random.nextInt(good.size)) else good.copyOf()
                if (it % 2 == 1) repeat(1 + random.nextInt(2)) { bytes[random.nextInt(bytes.size)] = "0123456789 -.\n\"$".random(random) }
                try {
                    MshReader.read(bytes, "x")
                } catch (e: FileFormatException) {
                    assertTrue(e.line > 0)
                }
            }
        }
    }

    private fun String.random(random: java.util.Random): Byte = this[random.nextInt(length)].code.toByte()

    @Test
    fun `a failed write leaves the old file and no draft`() {
        val file = folder.resolve("old.msh")
        Files.writeString(file, "old")
        assertThrows(IllegalStateException::class.java) {
            AtomicFile.write(file) {
                it.write(1)
                error("disk on fire")
            }
        }
        assertEquals("old", Files.readString(file))
        AtomicFile.write(file) { it.write("new".toByteArray()) }
        assertEquals("new", Files.readString(file))
        Files.list(folder).use { assertEquals(1, it.count()) }
    }
}
