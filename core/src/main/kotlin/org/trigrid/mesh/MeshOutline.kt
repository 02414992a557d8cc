package org.trigrid.mesh

import org.trigrid.domain.Domain
import org.trigrid.domain.SegmentAssembly

/** The domain that a mesh fills. */
internal object MeshOutline {
    /** Boundary edges as segments, embedded edges as embedded ones, with their tags; nodes in the order of the mesh. */
    fun of(mesh: TriMesh): Domain {
        val count = mesh.boundaryEdgeCount
        val boundary = mesh.edges.copyOf(2 * count)
        val noNext = IntArray(count).also { it.fill(-1) }
        val assembly = SegmentAssembly(mesh.xy, boundary, mesh.edgeTags.copyOf(count), noNext, BooleanArray(count))
        for (edge in count until mesh.taggedEdgeCount) assembly.embed(mesh.edgeStart(edge), mesh.edgeEnd(edge), mesh.edgeTag(edge))
        return assembly.toDomain(mesh.tags, mesh.regionName)
    }
}
