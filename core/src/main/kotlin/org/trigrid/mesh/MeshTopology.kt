package org.trigrid.mesh

import org.trigrid.geometry.HalfEdges
import org.trigrid.geometry.Predicates

/** What follows from the elements of a mesh alone: neighbours, boundary edges, nodes round a node. Linear in the size. */
internal object MeshTopology {
    /**
     * The element across each edge, [TriMesh.NONE] where there is none.
     *
     * An edge of more than two elements is no mesh: the elements left over stay without a neighbour there, which
     * [MeshCheck] then names.
     *
     * @param elements size 3 * elementCount, anticlockwise, each in `0 until nodeCount`; not modified.
     */
    fun neighbours(nodeCount: Int, elements: IntArray): IntArray {
        val result = IntArray(elements.size) { TriMesh.NONE }
        // Half-edges still without a twin, chained by their lower node.
        val first = IntArray(nodeCount) { -1 }
        val next = IntArray(elements.size)
        for (half in elements.indices) {
            val a = elements[half]
            val b = elements[nextCorner(half)]
            val low = minOf(a, b)
            var before = -1
            var twin = first[low]
            while (twin >= 0 && !(elements[twin] == b && elements[nextCorner(twin)] == a)) {
                before = twin
                twin = next[twin]
            }
            if (twin < 0) {
                next[half] = first[low]
                first[low] = half
            } else {
                if (before < 0) first[low] = next[twin] else next[before] = next[twin]
                result[half] = twin / 3
                result[twin] = half / 3
            }
        }
        return result
    }

    /** The next half-edge, and so the next corner, of the same element. */
    fun nextCorner(half: Int): Int = HalfEdges.next(half)

    /** Start and end of every half-edge without a neighbour, in the order of elements; the domain is on the left. */
    fun boundaryEdges(elements: IntArray, neighbours: IntArray): IntArray {
        var count = 0
        for (n in neighbours) if (n < 0) count++
        val result = IntArray(2 * count)
        var at = 0
        for (half in neighbours.indices) {
            if (neighbours[half] >= 0) continue
            result[at++] = elements[half]
            result[at++] = elements[nextCorner(half)]
        }
        return result
    }

    /** Every edge once: 2 nodes an edge, lower node first. */
    fun edges(elements: IntArray, neighbours: IntArray): IntArray {
        var boundary = 0
        for (n in neighbours) if (n < 0) boundary++
        val result = IntArray(elements.size + boundary)
        var at = 0
        for (half in elements.indices) {
            if (!ownsEdge(half, neighbours)) continue
            val a = elements[half]
            val b = elements[nextCorner(half)]
            result[at++] = minOf(a, b)
            result[at++] = maxOf(a, b)
        }
        return if (at == result.size) result else result.copyOf(at)
    }

    /** Whether this is the half-edge that stands for its edge when each edge is to be taken once. */
    fun ownsEdge(half: Int, neighbours: IntArray): Boolean = neighbours[half] < half / 3

    /** Turns clockwise elements; flat ones stay as they are. [elements] is modified. */
    fun turnAnticlockwise(xy: DoubleArray, elements: IntArray) {
        for (t in 0 until elements.size / 3) {
            val a = elements[3 * t]
            val b = elements[3 * t + 1]
            val c = elements[3 * t + 2]
            val turn = Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
            if (turn < 0) {
                elements[3 * t + 1] = c
                elements[3 * t + 2] = b
            }
        }
    }
}
