package org.trigrid.io

import org.trigrid.geometry.IntList
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** Puts the middles that a file gives into the mesh of its corners. */
internal class QuadraticContents(
    private val complaint: Complaint,
    /** With the middles among its nodes, which are in no element. */
    private val corners: TriMesh,
    /** 3 per triangle as the file has them, by the mesh's node numbers; [middles] of its edges in this order. */
    private val triangles: IntList,
    private val middles: IntList,
    private val lines: IntList,
    private val lineMiddles: IntList,
) {
    private val middleOf = HashMap<Long, Int>(2 * triangles.size)

    fun toMesh(): QuadraticMesh {
        val isCorner = BooleanArray(corners.nodeCount)
        for (i in 0 until triangles.size) isCorner[triangles[i]] = true
        for (i in 0 until triangles.size) {
            if (isCorner[middles[i]]) complaint.fail("a node is the middle of an edge and a corner")
            val next = if (i % 3 == 2) i - 2 else i + 1
            put(triangles[i], triangles[next], middles[i])
        }
        for (i in 0 until lineMiddles.size) put(lines[2 * i], lines[2 * i + 1], lineMiddles[i])
        val six = QuadraticMesh.NODES_PER_ELEMENT
        val elements = IntArray(six * corners.elementCount) {
            val first = 3 * (it / six)
            val k = it % six
            if (k < 3) corners.elements[first + k] else middle(corners.elements[first + k - 3], corners.elements[first + (k - 2) % 3])
        }
        val three = QuadraticMesh.NODES_PER_EDGE
        val edges = IntArray(three * corners.taggedEdgeCount) {
            val a = corners.edgeStart(it / three)
            val b = corners.edgeEnd(it / three)
            if (it % three == 0) a else if (it % three == 1) b else middle(a, b)
        }
        val mesh = QuadraticMesh(
            corners.xy, elements, edges, corners.edgeTags, corners.boundaryEdgeCount, corners.tags, corners.parts, 0,
        )
        for (element in 0 until mesh.elementCount) {
            if (!(mesh.leastJacobian(element) > 0)) complaint.fail("triangle ${element + 1} of six nodes is folded")
        }
        return mesh
    }

    private fun put(a: Int, b: Int, middle: Int) {
        val before = middleOf.put(key(a, b), middle)
        if (before != null && before != middle) complaint.fail("an edge has two middles")
    }

    private fun middle(a: Int, b: Int): Int = middleOf.getValue(key(a, b))

    private fun key(a: Int, b: Int): Long = (minOf(a, b).toLong() shl 32) or maxOf(a, b).toLong()
}
