package org.trigrid.numbering

import org.trigrid.mesh.TriMesh

/** Renumbers the nodes of meshes for solvers that store a band or a profile. */
public object Numbering {
    /**
     * New numbers for the nodes of [mesh]. With [NumberingMethod.BEST] the bandwidth, and the profile at the same
     * bandwidth, is never worse than it was.
     */
    @JvmStatic
    public fun permutation(mesh: TriMesh, method: NumberingMethod): Permutation =
        Renumbering.order(NodeGraph.of(mesh), Renumbering.boundaryWalks(mesh), method)

    /** [mesh] with its nodes renumbered and its elements in the order of their nodes. */
    @JvmStatic
    public fun renumber(mesh: TriMesh, method: NumberingMethod): TriMesh =
        if (method == NumberingMethod.NONE) mesh else permutation(mesh, method).apply(mesh)

    /** Bandwidth and profile of a mesh as it is. */
    @JvmStatic
    public fun metrics(mesh: TriMesh): NumberingMetrics = NumberingMetrics.of(mesh)
}
