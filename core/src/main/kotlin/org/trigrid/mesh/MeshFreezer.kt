package org.trigrid.mesh

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain

/** Makes the immutable mesh of a finished [MutableMesh]. */
internal object MeshFreezer {
    /** @param domain whose nodes are the mesh's first nodes; gives the tagged edges, the embedded ones last. */
    fun freeze(mesh: MutableMesh, domain: Domain, checkpoint: Checkpoint = Checkpoint.unheard()): TriMesh {
        val halfEdges = 3 * mesh.elementCount
        val neighbours = IntArray(halfEdges) {
            checkpoint.pass()
            val twin = mesh.twins[it]
            if (twin < 0) TriMesh.NONE else twin / 3
        }
        val kinds = TriMeshFactory.kinds(mesh.nodeCount, domain.segments, domain.boundaryCount)
        checkpoint.ask()
        val xy = mesh.xy.copyOf(2 * mesh.nodeCount)
        val elements = mesh.elements.copyOf(halfEdges)
        checkpoint.ask()
        return TriMesh(
            xy,
            elements,
            neighbours,
            kinds,
            domain.segments.copyOf(),
            domain.segmentTags.copyOf(),
            domain.boundaryCount,
            domain.tags,
            domain.regionName,
        )
    }
}
