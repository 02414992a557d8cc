package org.trigrid.fem

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.trigrid.mesh.GridMeshes
import org.trigrid.mesh.TriMesh
import java.util.BitSet

class SparsityPatternTest {
    private val mesh = GridMeshes.shaken(6, 5, 11L) { i, j -> i == 2 && j == 2 }.mesh

    @Test
    fun `entries are the pairs of unknowns that share an element`() {
        for (k in 1..3) {
            val pattern = SparsityPattern.of(mesh, k)
            val expected = pairs(k)
            assertEquals(k * mesh.nodeCount, pattern.rowCount)
            assertEquals(expected.sumOf { it.cardinality() }, pattern.entryCount)
            for (row in 0 until pattern.rowCount) {
                val columns = pattern.columns().copyOfRange(pattern.rowStart(row), pattern.rowStart(row + 1))
                assertArrayEquals(expected[row].stream().toArray(), columns)
                for (column in 0 until pattern.rowCount) {
                    val entry = pattern.entryOf(row, column)
                    assertEquals(expected[row].get(column), entry >= 0)
                    if (entry >= 0) assertEquals(column, pattern.column(entry)) else assertEquals(-1, entry)
                }
            }
        }
    }

    @Test
    fun `an element's numbers go to the entries of its unknowns`() {
        val pattern = SparsityPattern.of(mesh, 2)
        val entries = pattern.elementEntries()
        assertEquals(36 * mesh.elementCount, entries.size)
        for (t in 0 until mesh.elementCount) for (a in 0..2) for (b in 0..2) for (c in 0..1) for (d in 0..1) {
            val entry = entries[36 * t + 6 * (2 * a + c) + 2 * b + d]
            assertEquals(pattern.entryOf(2 * mesh.nodeOf(t, a) + c, 2 * mesh.nodeOf(t, b) + d), entry)
        }
    }

    @Test
    fun `the rows of an assembled Laplace matrix add up to 0`() {
        val pattern = SparsityPattern.of(mesh)
        val elements = LinearElements.of(mesh)
        val entries = pattern.elementEntries()
        val values = DoubleArray(pattern.entryCount)
        for (t in 0 until mesh.elementCount) for (i in 0..2) for (j in 0..2) {
            values[entries[9 * t + 3 * i + j]] += elements.area(t) *
                (elements.gradientX(t, i) * elements.gradientX(t, j) + elements.gradientY(t, i) * elements.gradientY(t, j))
        }
        val starts = pattern.rowStarts()
        for (row in 0 until pattern.rowCount) {
            assertTrue(values[pattern.entryOf(row, row)] > 0)
            assertEquals(0.0, values.copyOfRange(starts[row], starts[row + 1]).sum(), 1e-12)
        }
    }

    @Test
    fun `a node without elements has its diagonal only`() {
        val lonely = TriMesh.of(doubleArrayOf(0.0, 0.0, 9.0, 9.0, 1.0, 0.0, 0.0, 1.0), intArrayOf(0, 2, 3))
        val pattern = SparsityPattern.of(lonely)
        assertArrayEquals(intArrayOf(0, 3, 4, 7, 10), pattern.rowStarts())
        assertArrayEquals(intArrayOf(0, 2, 3, 1, 0, 2, 3, 0, 2, 3), pattern.columns())
    }

    @Test
    fun `elements of six nodes`() {
        // A square of two triangles, the middles of their edges numbered from 4.
        val nodes = intArrayOf(0, 1, 2, 4, 5, 6, 0, 2, 3, 6, 7, 8)
        val pattern = SparsityPattern.ofElements(9, nodes, 6, 1)
        assertArrayEquals(IntArray(9) { it }, pattern.columns().copyOfRange(pattern.rowStart(0), pattern.rowStart(1)))
        assertArrayEquals(intArrayOf(0, 2, 3, 6, 7, 8), pattern.columns().copyOfRange(pattern.rowStart(3), pattern.rowStart(4)))
        assertEquals(3 * 9 + 6 * 6, pattern.entryCount)
        val entries = pattern.elementEntries()
        assertEquals(72, entries.size)
        for (i in 0..5) for (j in 0..5) {
            assertEquals(pattern.entryOf(nodes[6 + i], nodes[6 + j]), entries[36 + 6 * i + j])
        }
        assertThrows<IllegalArgumentException> { SparsityPattern.ofElements(8, nodes, 6, 1) }
        assertThrows<IllegalArgumentException> { SparsityPattern.ofElements(9, nodes, 5, 1) }
    }

    @Test
    fun `no unknowns and too many are refused`() {
        assertThrows<IllegalArgumentException> { SparsityPattern.of(mesh, 0) }
        assertThrows<IllegalArgumentException> { SparsityPattern.of(mesh, 1_000_000) }
    }

    private fun pairs(k: Int): List<BitSet> {
        val rows = List(k * mesh.nodeCount) { BitSet() }
        for (t in 0 until mesh.elementCount) for (a in 0..2) for (b in 0..2) for (c in 0 until k) {
            rows[k * mesh.nodeOf(t, a) + c].set(k * mesh.nodeOf(t, b), k * mesh.nodeOf(t, b) + k)
        }
        return rows
    }
}
