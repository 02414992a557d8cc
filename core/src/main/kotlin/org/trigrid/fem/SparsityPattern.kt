package org.trigrid.fem

import org.trigrid.mesh.TriMesh
import java.util.Arrays

/**
 * Which entries of a coefficient matrix of finite elements are not zero, in compressed rows: the unknowns of a node meet
 * their own and those of all nodes with which it shares an element. Symmetric, so the same arrays are its compressed
 * columns. Component c of a node is unknown `unknownsPerNode * node + c`.
 *
 * A program assembles into an array of [entryCount] values: those of [elementEntries] say where each number of an element's
 * matrix is to be added. Immutable.
 *
 * @sample org.trigrid.samples.HeatInMachinePart.addConduction
 */
public class SparsityPattern private constructor(
    private val elementNodes: IntArray,
    /** 3 for linear triangles. */
    @get:JvmName("nodesPerElement") public val nodesPerElement: Int,
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
     * Entries to which the numbers of each element's matrix are added. That matrix has
     * n = [nodesPerElement] * [unknownsPerNode] rows, component by component for its first node, then the next; its row i and
     * column j go to `elementEntries()[n * n * element + n * i + j]`. A new array of n * n numbers an element.
     *
     * @throws IllegalArgumentException if an array cannot hold that many.
     */
    public fun elementEntries(): IntArray {
        val n = nodesPerElement * unknownsPerNode
        val elementCount = elementNodes.size / nodesPerElement
        val result = IntArray(sizeOf(n.toLong() * n * elementCount))
        var at = 0
        for (element in 0 until elementCount) {
            for (i in 0 until n) for (j in 0 until n) result[at++] = entryOf(unknown(element, i), unknown(element, j))
        }
        return result
    }

    private fun unknown(element: Int, local: Int) =
        unknownsPerNode * elementNodes[nodesPerElement * element + local / unknownsPerNode] + local % unknownsPerNode

    public companion object {
        /** The pattern of one unknown a node. */
        @JvmStatic
        public fun of(mesh: TriMesh): SparsityPattern = of(mesh, 1)

        /**
         * The pattern of linear elements.
         *
         * @param unknownsPerNode 1 or more.
         * @throws IllegalArgumentException if it is less, or there are more entries than an array can hold.
         */
        @JvmStatic
        public fun of(mesh: TriMesh, unknownsPerNode: Int): SparsityPattern =
            of(mesh.nodeCount, mesh.elements, 3, unknownsPerNode)

        /**
         * The pattern of elements of any kind, such as triangles with 6 nodes.
         *
         * @param elementNodes [nodesPerElement] nodes an element, numbered from 0; not modified.
         * @throws IllegalArgumentException if a number is out of range, the array does not hold whole elements, or there are more
         * entries than an array can hold.
         */
        @JvmStatic
        public fun ofElements(nodeCount: Int, elementNodes: IntArray, nodesPerElement: Int, unknownsPerNode: Int): SparsityPattern {
            require(nodesPerElement >= 1) { "nodes per element must be 1 or more, not $nodesPerElement" }
            require(elementNodes.size % nodesPerElement == 0) {
                "${elementNodes.size} nodes are no elements of $nodesPerElement nodes each"
            }
            for (node in elementNodes) require(node in 0 until nodeCount) { "an element has node $node of $nodeCount nodes" }
            return of(nodeCount, elementNodes.copyOf(), nodesPerElement, unknownsPerNode)
        }

        private fun of(nodeCount: Int, elementNodes: IntArray, nodesPerElement: Int, unknownsPerNode: Int): SparsityPattern {
            require(unknownsPerNode >= 1) { "unknowns per node must be 1 or more, not $unknownsPerNode" }
            val nodeStarts = IntArray(nodeCount + 1)
            val nodes = rows(nodeCount, elementNodes, nodesPerElement, nodeStarts)
            val k = unknownsPerNode
            if (k == 1) return SparsityPattern(elementNodes, nodesPerElement, 1, nodeStarts, nodes)
            val starts = IntArray(sizeOf(k.toLong() * nodeCount + 1))
            val columns = IntArray(sizeOf(k.toLong() * k * nodes.size))
            var at = 0
            for (row in 0 until starts.size - 1) {
                for (entry in nodeStarts[row / k] until nodeStarts[row / k + 1]) {
                    for (c in 0 until k) columns[at++] = k * nodes[entry] + c
                }
                starts[row + 1] = at
            }
            return SparsityPattern(elementNodes, nodesPerElement, k, starts, columns)
        }

        /** For each node itself and its neighbours, ascending; [starts], all zeros, gets where they begin. */
        private fun rows(nodeCount: Int, elementNodes: IntArray, nodesPerElement: Int, starts: IntArray): IntArray {
            val firsts = IntArray(nodeCount + 1)
            for (node in elementNodes) firsts[node + 1]++
            for (node in 1..nodeCount) firsts[node] += firsts[node - 1]
            val elements = IntArray(elementNodes.size)
            val next = firsts.copyOf()
            for (i in elementNodes.indices) elements[next[elementNodes[i]]++] = i / nodesPerElement
            val seenBy = IntArray(nodeCount) { -1 }
            var rows = IntArray(sizeOf(7L * nodeCount + 1))
            var at = 0
            for (node in 0 until nodeCount) {
                val needed = at.toLong() + 1 + (firsts[node + 1] - firsts[node]).toLong() * nodesPerElement
                if (needed > rows.size) rows = rows.copyOf(sizeOf(maxOf(needed, minOf(2L * rows.size, Int.MAX_VALUE - 8L))))
                rows[at++] = node
                seenBy[node] = node
                for (i in firsts[node] until firsts[node + 1]) {
                    for (k in nodesPerElement * elements[i] until nodesPerElement * (elements[i] + 1)) {
                        val other = elementNodes[k]
                        if (seenBy[other] == node) continue
                        seenBy[other] = node
                        rows[at++] = other
                    }
                }
                Arrays.sort(rows, starts[node], at)
                starts[node + 1] = at
            }
            return rows.copyOf(at)
        }

        private fun sizeOf(entries: Long): Int {
            require(entries <= Int.MAX_VALUE - 8) { "$entries entries are more than an array can hold" }
            return entries.toInt()
        }
    }
}
