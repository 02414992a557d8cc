package org.trigrid.mesh

import org.trigrid.geometry.IntList

/** Finds the two sides of each edge along which parts of a mesh meet. */
internal class MeshSeams {
    private val ends = ArrayList<Long>()
    private val halfEdges = IntList()

    /** A half-edge from [a] to [b] without a twin in its part; one of the boundary does no harm. */
    fun add(a: Int, b: Int, halfEdge: Int) {
        ends.add((Math.min(a, b).toLong() shl 32) or Math.max(a, b).toLong())
        halfEdges.add(halfEdge)
    }

    /** Makes the two half-edges between the same nodes each other's twins. */
    fun link(twins: IntArray) {
        val order = ends.indices.sortedBy { ends[it] }
        for (i in 1 until order.size) {
            val one = order[i - 1]
            val other = order[i]
            if (ends[one] != ends[other]) continue
            twins[halfEdges[one]] = halfEdges[other]
            twins[halfEdges[other]] = halfEdges[one]
        }
    }
}
