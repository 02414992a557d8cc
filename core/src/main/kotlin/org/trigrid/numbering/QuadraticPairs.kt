package org.trigrid.numbering

import org.trigrid.mesh.QuadraticMesh
import java.util.BitSet

/** The pairs of nodes that share an element of six nodes, each once. */
internal object QuadraticPairs {
    /** Places of the pairs that no other element has: a middle with another, a corner with the middle opposite. */
    private val OWN = intArrayOf(3, 4, 4, 5, 5, 3, 0, 4, 1, 5, 2, 3)

    /** Two nodes a pair. */
    fun of(mesh: QuadraticMesh): IntArray {
        val middles = BitSet(mesh.nodeCount)
        for (element in 0 until mesh.elementCount) for (k in 3..5) middles.set(mesh.nodeOf(element, k))
        val count = OWN.size.toLong() * mesh.elementCount + 6L * middles.cardinality()
        require(count < Int.MAX_VALUE) { "${mesh.elementCount} elements of six nodes are too many to be renumbered" }
        val pairs = IntArray(count.toInt())
        var at = 0
        for (element in 0 until mesh.elementCount) {
            for (place in OWN) pairs[at++] = mesh.nodeOf(element, place)
            for (k in 0..2) {
                val middle = mesh.nodeOf(element, 3 + k)
                // The first element at an edge has its pairs.
                if (!middles.get(middle)) continue
                middles.clear(middle)
                at = addEdge(mesh.nodeOf(element, k), mesh.nodeOf(element, (k + 1) % 3), middle, pairs, at)
            }
        }
        return pairs
    }

    private fun addEdge(a: Int, b: Int, middle: Int, pairs: IntArray, start: Int): Int {
        var at = start
        for (node in intArrayOf(a, b, a, middle, middle, b)) pairs[at++] = node
        return at
    }
}
