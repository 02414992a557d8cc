package org.trigrid.mesh

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain

/** Makes the immutable mesh of a finished [MutableMesh]. */
internal object MeshFreezer {
    /** @param domain whose nodes are the mesh's first nodes; gives the tagged edges, the embedded ones last, points and regions. */
    fun freeze(mesh: MutableMesh, domain: Domain, checkpoint: Checkpoint = Checkpoint.unheard()): TriMesh {
        val halfEdges = 3 * mesh.elementCount
        val neighbours = IntArray(halfEdges) {
            checkpoint.pass()
            val twin = mesh.twins[it]
            if (twin < 0) TriMesh.NONE else twin / 3
        }
        val kinds = TriMeshFactory.kinds(mesh.nodeCount, domain.segments, domain.boundaryCount, domain.points.nodes)
        checkpoint.ask()
        val xy = mesh.xy.copyOf(2 * mesh.nodeCount)
        val elements = mesh.elements.copyOf(halfEdges)
        checkpoint.ask()
        val parts = MeshParts(domain.regions, regions(mesh, elements, neighbours, domain), domain.points.nodes, domain.points.tags)
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
            parts,
        )
    }

    private fun regions(mesh: MutableMesh, elements: IntArray, neighbours: IntArray, domain: Domain): IntArray {
        if (domain.regionMap.isSingle) return IntArray(0)
        val sides = TaggedSides(mesh.nodeCount, elements, 3, domain.segments, 2)
        return RegionFlood(neighbours, sides, domain.segmentCount).regions(domain::regionOnLeft, domain::regionOnRight)
    }
}
