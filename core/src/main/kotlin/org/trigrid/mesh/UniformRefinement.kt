package org.trigrid.mesh

/** Divides every element into four by the middles of its edges. */
internal class UniformRefinement(private val mesh: TriMesh, private val middles: EdgeMiddles) {
    private val halves = 3 * mesh.elementCount

    private val numbers = EdgeNumbers(mesh)
    private val nodeCount = mesh.nodeCount + numbers.count

    fun refined(): TriMesh {
        require(4L * halves < Int.MAX_VALUE) { "${mesh.elementCount} elements are too many to be divided" }
        val tags = IntArray(2 * mesh.taggedEdgeCount) { mesh.edgeTag(it / 2) }
        val regions = IntArray(4 * mesh.parts.elementRegions.size) { mesh.parts.elementRegions[it / 4] }
        val parts = MeshParts(mesh.regions, regions, mesh.parts.points, mesh.parts.pointTags)
        return TriMeshFactory.of(places(), elements(), lines(), tags, mesh.tags, parts)
    }

    /** Node in the middle of each half-edge. */
    private fun middle(half: Int) = mesh.nodeCount + numbers.of(half)

    private fun places(): DoubleArray {
        val xy = mesh.xy.copyOf(2 * nodeCount)
        for (half in 0 until halves) {
            val a = mesh.elements[half]
            val b = mesh.elements[MeshTopology.nextCorner(half)]
            val m = middle(half)
            xy[2 * m] = EdgeMiddles.halfway(mesh.x(a), mesh.x(b))
            xy[2 * m + 1] = EdgeMiddles.halfway(mesh.y(a), mesh.y(b))
        }
        val sides = TaggedSides(mesh)
        for (edge in 0 until mesh.taggedEdgeCount) {
            val place = middles.middleOf(mesh, edge)
            val m = middle(sides.leftOf(edge))
            xy[2 * m] = place[0]
            xy[2 * m + 1] = place[1]
        }
        return xy
    }

    private fun elements(): IntArray {
        val result = IntArray(4 * halves)
        var at = 0
        for (t in 0 until halves step 3) {
            for (k in 0..2) {
                result[at++] = mesh.elements[t + k]
                result[at++] = middle(t + k)
                result[at++] = middle(t + (k + 2) % 3)
            }
            for (k in 0..2) result[at++] = middle(t + k)
        }
        return result
    }

    private fun lines(): IntArray {
        val sides = TaggedSides(mesh)
        val result = IntArray(4 * mesh.taggedEdgeCount)
        for (edge in 0 until mesh.taggedEdgeCount) {
            val m = middle(sides.leftOf(edge))
            result[4 * edge] = mesh.edgeStart(edge)
            result[4 * edge + 1] = m
            result[4 * edge + 2] = m
            result[4 * edge + 3] = mesh.edgeEnd(edge)
        }
        return result
    }
}
