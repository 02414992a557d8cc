package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** Renumbers the nodes of meshes for solvers that store a band or a profile. */
public object Numbering {
    /**
     * New numbers for the nodes of [mesh]. With [NumberingMethod.BEST] the bandwidth, and the profile at the same
     * bandwidth, is never worse than it was.
     */
    @JvmStatic
    public fun permutation(mesh: TriMesh, method: NumberingMethod): Permutation =
        permutation(mesh, method, Checkpoint.unheard())

    private fun permutation(mesh: TriMesh, method: NumberingMethod, checkpoint: Checkpoint): Permutation =
        Renumbering.order(NodeGraph.of(mesh, checkpoint), Renumbering.boundaryWalks(mesh, checkpoint), method, checkpoint)

    /** [mesh] with its nodes renumbered and its elements in the order of their nodes. */
    @JvmStatic
    public fun renumber(mesh: TriMesh, method: NumberingMethod): TriMesh =
        renumber(mesh, method, Checkpoint.unheard())

    /** As for a [TriMesh], all six nodes of an element being neighbours. */
    @JvmStatic
    public fun permutation(mesh: QuadraticMesh, method: NumberingMethod): Permutation =
        Renumbering.order(NodeGraph.of(mesh), Renumbering.boundaryWalks(mesh), method)

    /** [mesh] with its nodes renumbered, corners and middles, and its elements in the order of their corners. */
    @JvmStatic
    public fun renumber(mesh: QuadraticMesh, method: NumberingMethod): QuadraticMesh =
        if (method == NumberingMethod.NONE) mesh else mesh.renumbered(permutation(mesh, method).newNumbersShared())

    internal fun renumber(mesh: TriMesh, method: NumberingMethod, checkpoint: Checkpoint): TriMesh =
        if (method == NumberingMethod.NONE) mesh else permutation(mesh, method, checkpoint).apply(mesh, checkpoint)

    /** Bandwidth and profile of a mesh as it is. */
    @JvmStatic
    public fun metrics(mesh: TriMesh): NumberingMetrics = NumberingMetrics.of(mesh)

    /** Bandwidth and profile of a mesh as it is. */
    @JvmStatic
    public fun metrics(mesh: QuadraticMesh): NumberingMetrics = NumberingMetrics.of(mesh)
}
