package org.trigrid.fem

import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.TriMesh
import java.util.Arrays

/**
 * Which entries of the coefficient matrix of linear elements are not zero, in compressed rows: the unknowns of a node meet
 * their own and those of all nodes with which it shares an element. Symmetric, so the same arrays are its compressed
 * columns. Component c of a node is unknown `unknownsPerNode * node + c`.
 *
 * A program assembles into an array of [entryCount] values: those of [elementEntries] say where each number of an element's
 * matrix is to be added. Immutable.
 *
 * @sample org.trigrid.samples.HeatInMachinePart.addConduction
 */
public class SparsityPattern private constructor(
    private val mesh: TriMesh,
    /** 1 for a scalar field, 2 for plane displacements. */
    @get:JvmName("unknownsPerNode") public val unknownsPerNode: Int,
    internal val starts: IntArray,
    internal val columns: IntArray,
) {
    /** Rows, and columns: nodeCount * [unknownsPerNode]. */
    @get:JvmName("rowCount")
    public val rowCount: Int get() = starts.size - 1

    /** Entries that are not zero, of both triangles and the diagonal. */
    @get:JvmName("entryCount")
    public val entryCount: Int get() = columns.size

    /** Number of the first entry of each row, and [entryCount] at the end; size rowCount + 1. A copy. */
    public fun rowStarts(): IntArray = starts.copyOf()

    /** Column of each entry, ascending in each row; size entryCount. A copy. */
    public fun columns(): IntArray = columns.copyOf()

    /** Number of the first entry of [row]; `rowStart(rowCount)` ends the last row. */
    public fun rowStart(row: Int): Int = starts[row]

    /** Column of [entry]. */
    public fun column(entry: Int): Int = columns[entry]

    /** Number of the entry at [row] and [column], or -1 where the matrix is zero. */
    public fun entryOf(row: Int, column: Int): Int =
        Math.max(-1, Arrays.binarySearch(columns, starts[row], starts[row + 1], column))

    /**
     * Entries to which the numbers of each element's matrix are added. That matrix has n = 3 * [unknownsPerNode] rows,
     * component by component for corner 0, then corners 1 and 2; its row i and column j go to
     * `elementEntries()[n * n * element + n * i + j]`. A new array of n * n numbers an element.
     *
     * @throws IllegalArgumentException if an array cannot hold that many.
     */
    public fun elementEntries(): IntArray {
        val n = 3 * unknownsPerNode
        val result = IntArray(sizeOf(n.toLong() * n * mesh.elementCount))
        var at = 0
        for (element in 0 until mesh.elementCount) {
            for (i in 0 until n) for (j in 0 until n) result[at++] = entryOf(unknown(element, i), unknown(element, j))
        }
        return result
    }

    private fun unknown(element: Int, local: Int) =
        unknownsPerNode * mesh.nodeOf(element, local / unknownsPerNode) + local % unknownsPerNode

    public companion object {
        /** The pattern of one unknown a node. */
        @JvmStatic
        public fun of(mesh: TriMesh): SparsityPattern = of(mesh, 1)

        /**
         * @param unknownsPerNode 1 or more.
         * @throws IllegalArgumentException if it is less, or there are more entries than an array can hold.
         */
        @JvmStatic
        public fun of(mesh: TriMesh, unknownsPerNode: Int): SparsityPattern {
            require(unknownsPerNode >= 1) { "unknowns per node must be 1 or more, not $unknownsPerNode" }
            val nodeStarts = IntArray(mesh.nodeCount + 1)
            val nodes = rows(mesh, nodeStarts)
            val k = unknownsPerNode
            if (k == 1) return SparsityPattern(mesh, 1, nodeStarts, nodes)
            val starts = IntArray(sizeOf(k.toLong() * mesh.nodeCount + 1))
            val columns = IntArray(sizeOf(k.toLong() * k * nodes.size))
            var at = 0
            for (row in 0 until starts.size - 1) {
                for (entry in nodeStarts[row / k] until nodeStarts[row / k + 1]) {
                    for (c in 0 until k) columns[at++] = k * nodes[entry] + c
                }
                starts[row + 1] = at
            }
            return SparsityPattern(mesh, k, starts, columns)
        }

        /** For each node itself and its neighbours, ascending; [starts], all zeros, gets where they begin. */
        private fun rows(mesh: TriMesh, starts: IntArray): IntArray {
            val edges = MeshTopology.edges(mesh.elements, mesh.neighbours)
            for (node in 0 until mesh.nodeCount) starts[node + 1] = 1
            for (node in edges) starts[node + 1]++
            for (node in 1 until starts.size) starts[node] += starts[node - 1]
            val rows = IntArray(starts[mesh.nodeCount])
            val at = starts.copyOf()
            for (node in 0 until mesh.nodeCount) rows[at[node]++] = node
            for (i in edges.indices) rows[at[edges[i]]++] = edges[i xor 1]
            for (node in 0 until mesh.nodeCount) Arrays.sort(rows, starts[node], starts[node + 1])
            return rows
        }

        private fun sizeOf(entries: Long): Int {
            require(entries <= Int.MAX_VALUE - 8) { "$entries entries are more than an array can hold" }
            return entries.toInt()
        }
    }
}
