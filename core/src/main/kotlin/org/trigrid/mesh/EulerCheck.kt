package org.trigrid.mesh

import java.util.BitSet

/**
 * Euler's formula for a mesh whose parts may touch at nodes.
 *
 * A node where k boundary walks meet counts k times: the mesh, cut open there, is then a surface with smooth rim, of P
 * parts and L rims, and nodes - edges + elements = 2 P - L when each part is flat.
 */
internal class EulerCheck(private val mesh: TriMesh, private val found: ViolationList) {
    private val elements = mesh.elements
    private val neighbours = mesh.neighbours

    fun check() {
        val boundary = MeshTopology.boundaryEdges(elements, neighbours)
        val leaving = IntArray(mesh.nodeCount)
        for (i in boundary.indices step 2) leaving[boundary[i]]++
        var nodes = mesh.nodeCount.toLong()
        for (k in leaving) if (k > 1) nodes += k - 1
        val edges = (elements.size + boundary.size / 2) / 2L
        val parts = partCount()
        val rims = rimCount()
        val actual = nodes - edges + mesh.elementCount
        val expected = 2L * parts - rims
        if (actual == expected) return
        found.add(
            MeshViolationKind.EULER, Double.NaN, Double.NaN,
            "nodes - edges + elements is $actual, and should be $expected for $parts parts with $rims boundary walks",
        )
    }

    private fun partCount(): Int {
        val seen = BooleanArray(mesh.elementCount)
        val stack = IntArray(mesh.elementCount)
        var parts = 0
        for (seed in seen.indices) {
            if (seen[seed]) continue
            parts++
            var size = 1
            stack[0] = seed
            seen[seed] = true
            while (size > 0) {
                val t = stack[--size]
                for (half in 3 * t..3 * t + 2) {
                    val next = neighbours[half]
                    if (next < 0 || seen[next]) continue
                    seen[next] = true
                    stack[size++] = next
                }
            }
        }
        return parts
    }

    private fun rimCount(): Int {
        val seen = BitSet(elements.size)
        var rims = 0
        for (start in neighbours.indices) {
            if (neighbours[start] >= 0 || seen.get(start)) continue
            rims++
            var half = start
            while (!seen.get(half)) {
                seen.set(half)
                half = nextOnRim(half)
            }
        }
        return rims
    }

    /** Turns round the end of a boundary half-edge, through the elements there, to the next boundary half-edge. */
    private fun nextOnRim(half: Int): Int {
        var h = MeshTopology.nextCorner(half)
        while (neighbours[h] >= 0) h = MeshTopology.nextCorner(twin(h))
        return h
    }

    private fun twin(half: Int): Int {
        val first = 3 * neighbours[half]
        val end = elements[MeshTopology.nextCorner(half)]
        // The twin starts where this half-edge ends; an element has each node once.
        return if (elements[first] == end) first else if (elements[first + 1] == end) first + 1 else first + 2
    }
}
