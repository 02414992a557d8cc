package org.trigrid.mesh

/** The half-edge, 3 t + k for edge k of element t, on the left of each tagged edge. */
internal class TaggedSides(nodeCount: Int, elements: IntArray, nodesPerElement: Int, edges: IntArray, nodesPerEdge: Int) {
    private val halves = IntArray(edges.size / nodesPerEdge)

    constructor(mesh: TriMesh) : this(mesh.nodeCount, mesh.elements, 3, mesh.edges, 2)

    init {
        val first = IntArray(nodeCount) { -1 }
        val next = IntArray(halves.size)
        for (edge in halves.indices) {
            val start = edges[nodesPerEdge * edge]
            next[edge] = first[start]
            first[start] = edge
        }
        for (half in 0 until 3 * (elements.size / nodesPerElement)) {
            val corners = nodesPerElement * (half / 3)
            val end = elements[corners + (half % 3 + 1) % 3]
            var edge = first[elements[corners + half % 3]]
            while (edge >= 0) {
                if (edges[nodesPerEdge * edge + 1] == end) halves[edge] = half
                edge = next[edge]
            }
        }
    }

    fun leftOf(edge: Int): Int = halves[edge]
}
