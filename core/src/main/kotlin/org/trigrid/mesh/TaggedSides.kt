package org.trigrid.mesh

/** The half-edge, 3 t + k for edge k of element t, on the left of each tagged edge. */
internal class TaggedSides(mesh: TriMesh) {
    private val halves = IntArray(mesh.taggedEdgeCount)

    init {
        val first = IntArray(mesh.nodeCount) { -1 }
        val next = IntArray(mesh.taggedEdgeCount)
        for (edge in 0 until mesh.taggedEdgeCount) {
            next[edge] = first[mesh.edgeStart(edge)]
            first[mesh.edgeStart(edge)] = edge
        }
        for (half in 0 until 3 * mesh.elementCount) {
            var edge = first[mesh.elements[half]]
            while (edge >= 0) {
                if (mesh.edgeEnd(edge) == mesh.elements[MeshTopology.nextCorner(half)]) halves[edge] = half
                edge = next[edge]
            }
        }
    }

    fun leftOf(edge: Int): Int = halves[edge]
}
