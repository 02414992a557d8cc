package org.trigrid.io

import org.trigrid.geometry.IntList
import org.trigrid.mesh.EdgeNumbers
import org.trigrid.mesh.MeshParts
import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TaggedSides
import org.trigrid.mesh.TriMesh

/**
 * Makes the mesh of six-node elements of what was read, beside that of their corners.
 *
 * @param xy of all nodes of the file.
 * @param triangles three corners an element, and [middles] the nodes between them, by the nodes of the file.
 */
internal class QuadraticContents(
    private val xy: DoubleArray, private val triangles: IntList, private val middles: IntList, private val complaint: Complaint,
) {
    /**
     * @param corners the mesh of the elements' corners, in the order of the triangles but turned where they were clockwise.
     * @param cornerNumbers nodes of the file to those of [corners], -1 for others.
     */
    fun toMesh(corners: TriMesh, cornerNumbers: IntArray): QuadraticMesh {
        val fileNodes = IntArray(corners.nodeCount)
        for (node in cornerNumbers.indices) if (cornerNumbers[node] >= 0) fileNodes[cornerNumbers[node]] = node
        val numbers = EdgeNumbers(corners)
        val middleOf = middleOfEdges(corners, fileNodes, numbers, cornerNumbers)
        val newNumbers = newNumbers(cornerNumbers, middleOf)
        val elements = IntArray(NODES * corners.elementCount) {
            val half = 3 * (it / NODES) + it % 3
            newNumbers[if (it % NODES < 3) fileNodes[corners.elements[half]] else middleOf[numbers.of(half)]]
        }
        val sides = TaggedSides(corners)
        val edges = IntArray(EDGE_NODES * corners.taggedEdgeCount) {
            val edge = it / EDGE_NODES
            when (it % EDGE_NODES) {
                0 -> newNumbers[fileNodes[corners.edgeStart(edge)]]
                1 -> newNumbers[fileNodes[corners.edgeEnd(edge)]]
                else -> newNumbers[middleOf[numbers.of(sides.leftOf(edge))]]
            }
        }
        val given = corners.parts
        val points = IntArray(given.points.size) { newNumbers[fileNodes[given.points[it]]] }
        val parts = MeshParts(given.regions, given.elementRegions, points, given.pointTags)
        return QuadraticMesh(places(newNumbers), elements, edges, corners.edgeTags, corners.boundaryEdgeCount, corners.tags, parts, 0)
    }

    /** The node of the file in the middle of each edge: one only, and that of no other edge, nor a corner. */
    private fun middleOfEdges(corners: TriMesh, fileNodes: IntArray, numbers: EdgeNumbers, cornerNumbers: IntArray): IntArray {
        val middleOf = IntArray(numbers.count) { -1 }
        val edgeOf = IntArray(cornerNumbers.size) { -1 }
        for (half in 0 until triangles.size) {
            val a = fileNodes[corners.elements[half]]
            val b = fileNodes[corners.elements[MeshTopology.nextCorner(half)]]
            val middle = middles[halfOf(half / 3, a, b)]
            val edge = numbers.of(half)
            if (middleOf[edge] >= 0 && middleOf[edge] != middle) fail(middle, "is not what the other element has in the middle of the edge")
            if (cornerNumbers[middle] >= 0 || edgeOf[middle] >= 0 && edgeOf[middle] != edge) fail(middle, "is the middle of an edge, and something else too")
            middleOf[edge] = middle
            edgeOf[middle] = edge
        }
        return middleOf
    }

    /** The half-edge of the file's triangle [element] between two of its corners. */
    private fun halfOf(element: Int, a: Int, b: Int): Int = (3 * element..3 * element + 2).first { half ->
        val start = triangles[half]
        val end = triangles[MeshTopology.nextCorner(half)]
        start == a && end == b || start == b && end == a
    }

    /** Nodes of the file to those of the mesh, which has them in their order. */
    private fun newNumbers(cornerNumbers: IntArray, middleOf: IntArray): IntArray {
        val numbers = IntArray(cornerNumbers.size) { if (cornerNumbers[it] >= 0) 0 else -1 }
        for (node in middleOf) numbers[node] = 0
        var used = 0
        for (node in numbers.indices) if (numbers[node] == 0) numbers[node] = used++
        return numbers
    }

    private fun places(newNumbers: IntArray): DoubleArray {
        val places = DoubleArray(2 * newNumbers.count { it >= 0 })
        for (node in newNumbers.indices) {
            if (newNumbers[node] < 0) continue
            for (c in 0..1) {
                if (!xy[2 * node + c].isFinite()) fail(node, "is at no finite place")
                places[2 * newNumbers[node] + c] = xy[2 * node + c]
            }
        }
        return places
    }

    private fun fail(node: Int, reason: String): Nothing = complaint.fail("the node at (${xy[2 * node]}, ${xy[2 * node + 1]}) $reason")

    private companion object {
        const val NODES = QuadraticMesh.NODES_PER_ELEMENT
        const val EDGE_NODES = QuadraticMesh.NODES_PER_EDGE
    }
}
