package org.trigrid.mesh

/** Checks that elements meet edge to edge: each inner edge in exactly two, and the neighbours are those. */
internal class ConformityCheck(private val mesh: TriMesh, private val found: ViolationList) {
    private val elements = mesh.elements
    private val neighbours = mesh.neighbours

    /** Per node, where its outgoing half-edges start in [ends]; one entry more than nodes. */
    private val starts = IntArray(mesh.nodeCount + 1)
    private val ends = IntArray(elements.size)

    init {
        for (node in elements) starts[node + 1]++
        for (n in 1 until starts.size) starts[n] += starts[n - 1]
        val at = starts.copyOf()
        for (half in elements.indices) ends[at[elements[half]]++] = elements[MeshTopology.nextCorner(half)]
    }

    /** Each directed edge in at most one element: with that no edge is in more than two. */
    fun checkEdges() {
        val lastStart = IntArray(mesh.nodeCount) { -1 }
        for (a in 0 until mesh.nodeCount) {
            for (i in starts[a] until starts[a + 1]) {
                val b = ends[i]
                if (lastStart[b] == a) {
                    found.atEdge(MeshViolationKind.SHARED_TOO_OFTEN, a, b, "belongs to two elements on its same side")
                }
                lastStart[b] = a
            }
        }
    }

    /** @return whether all neighbours are right. */
    fun checkNeighbours(): Boolean {
        var sound = true
        for (half in elements.indices) {
            val a = elements[half]
            val b = elements[MeshTopology.nextCorner(half)]
            val neighbour = neighbours[half]
            if (neighbour < 0) {
                if (!exists(b, a)) continue
                sound = false
                found.atEdge(MeshViolationKind.WRONG_NEIGHBOUR, a, b, "has elements on both sides that do not know each other")
            } else if (!meets(neighbour, b, a, half / 3)) {
                sound = false
                found.atEdge(
                    MeshViolationKind.WRONG_NEIGHBOUR, a, b,
                    "of element ${half / 3} is said to lead to element $neighbour, which does not have it",
                )
            }
        }
        return sound
    }

    private fun exists(from: Int, to: Int): Boolean {
        for (i in starts[from] until starts[from + 1]) if (ends[i] == to) return true
        return false
    }

    private fun meets(element: Int, from: Int, to: Int, back: Int): Boolean {
        for (half in 3 * element..3 * element + 2) {
            if (neighbours[half] == back && elements[half] == from && elements[MeshTopology.nextCorner(half)] == to) return true
        }
        return false
    }
}
