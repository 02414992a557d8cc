package org.trigrid.mesh

import java.util.BitSet

/** Checks that the tagged edges of a mesh are its boundary edges and inner edges, each once and with a tag. */
internal class TaggedEdgeCheck(private val mesh: TriMesh, private val found: ViolationList) {
    private val boundary = MeshTopology.boundaryEdges(mesh.elements, mesh.neighbours)

    fun check() {
        checkTags()
        checkBoundary()
        checkEmbedded()
        checkKinds()
    }

    private fun checkTags() {
        for (edge in 0 until mesh.taggedEdgeCount) {
            val tag = mesh.edgeTags[edge]
            if (tag in mesh.tags.indices) continue
            found.atEdge(MeshViolationKind.WRONG_TAGGED_EDGE, mesh.edgeStart(edge), mesh.edgeEnd(edge), "has no tag: $tag")
        }
    }

    private fun checkBoundary() {
        val listed = LongArray(mesh.boundaryEdgeCount) { directed(mesh.edgeStart(it), mesh.edgeEnd(it)) }.also { it.sort() }
        val actual = LongArray(boundary.size / 2) { directed(boundary[2 * it], boundary[2 * it + 1]) }.also { it.sort() }
        for (i in 1 until listed.size) if (listed[i] == listed[i - 1]) report(listed[i], "is listed twice as a boundary edge")
        for (key in listed) {
            if (actual.binarySearch(key) < 0) report(key, "is listed as a boundary edge and is none in this direction")
        }
        for (key in actual) if (listed.binarySearch(key) < 0) report(key, "is a boundary edge and is not listed as one")
    }

    private fun checkEmbedded() {
        if (mesh.taggedEdgeCount == mesh.boundaryEdgeCount) return
        val onLine = BitSet()
        for (i in 2 * mesh.boundaryEdgeCount until mesh.edges.size) onLine.set(mesh.edges[i])
        val inner = ArrayList<Long>()
        for (half in mesh.elements.indices) {
            val a = mesh.elements[half]
            if (mesh.neighbours[half] < 0 || !onLine.get(a)) continue
            val b = mesh.elements[MeshTopology.nextCorner(half)]
            if (onLine.get(b)) inner.add(directed(a, b))
        }
        val keys = inner.toLongArray().also { it.sort() }
        val seen = HashSet<Long>()
        for (edge in mesh.boundaryEdgeCount until mesh.taggedEdgeCount) {
            val a = mesh.edgeStart(edge)
            val b = mesh.edgeEnd(edge)
            if (keys.binarySearch(directed(a, b)) < 0) report(directed(a, b), "is listed as embedded and is no inner edge")
            if (!seen.add(directed(minOf(a, b), maxOf(a, b)))) report(directed(a, b), "is listed twice as embedded")
        }
    }

    private fun checkKinds() {
        val expected = TriMeshFactory.kinds(mesh.nodeCount, mesh.edges, mesh.boundaryEdgeCount, mesh.parts.points)
        for (i in boundary) expected[i] = NodeKind.BOUNDARY.code
        for (node in expected.indices) {
            val kind = mesh.kinds[node]
            // A given node may lie alone inside the domain, on no embedded edge.
            if (kind == expected[node] || kind == NodeKind.EMBEDDED.code && expected[node] == NodeKind.INTERIOR.code) continue
            found.atNode(MeshViolationKind.WRONG_KIND, node, "is of kind ${mesh.kindOf(node)}, its edges say ${NodeKind.of(expected[node])}")
        }
    }

    private fun directed(a: Int, b: Int): Long = (a.toLong() shl 32) or b.toLong()

    private fun report(key: Long, what: String) =
        found.atEdge(MeshViolationKind.WRONG_TAGGED_EDGE, (key ushr 32).toInt(), key.toInt(), what)
}
