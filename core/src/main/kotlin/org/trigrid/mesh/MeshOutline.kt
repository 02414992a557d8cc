package org.trigrid.mesh

import org.trigrid.domain.Domain
import org.trigrid.domain.DomainPoints
import org.trigrid.domain.DomainRegions
import org.trigrid.domain.SegmentAssembly

/** The domain that a mesh fills. */
internal object MeshOutline {
    /** Boundary edges as segments, embedded edges and points as such, with tags and regions; nodes in the order of the mesh. */
    fun of(mesh: TriMesh): Domain {
        val count = mesh.boundaryEdgeCount
        val boundary = mesh.edges.copyOf(2 * count)
        val noNext = IntArray(count).also { it.fill(-1) }
        // In the place of tags the assembly carries the numbers of tagged edges along.
        val assembly = SegmentAssembly(mesh.xy, boundary, IntArray(count) { it }, noNext, BooleanArray(count))
        for (edge in count until mesh.taggedEdgeCount) assembly.embed(mesh.edgeStart(edge), mesh.edgeEnd(edge), edge)
        val points = DomainPoints(mesh.parts.points, mesh.parts.pointTags)
        val tagsOf = { edges: IntArray -> IntArray(edges.size) { mesh.edgeTag(edges[it]) } }
        return assembly.toDomain(mesh.tags, points, tagsOf) { edges -> regions(mesh, edges) }
    }

    private fun regions(mesh: TriMesh, edges: IntArray): DomainRegions {
        if (mesh.regions.size == 1) return DomainRegions(mesh.regions, IntArray(0), emptyList())
        val taggedSides = TaggedSides(mesh)
        val sides = IntArray(2 * edges.size) {
            val half = taggedSides.leftOf(edges[it / 2])
            val element = if (it % 2 == 0) half / 3 else mesh.neighbours[half]
            if (element < 0) -1 else mesh.regionOf(element)
        }
        return DomainRegions(mesh.regions, sides, emptyList())
    }
}
