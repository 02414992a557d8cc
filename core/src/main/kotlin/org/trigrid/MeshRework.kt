package org.trigrid

import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.front.Strategy
import org.trigrid.improve.MeshImprovement
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.EdgeSet
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MeshParts
import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.MutableMesh
import org.trigrid.mesh.NodeKind
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.RegionFlood
import org.trigrid.mesh.TaggedSides
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory
import org.trigrid.mesh.UniformRefinement
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.quality.QualityReport

/** Makes better or finer meshes of meshes that are there, whoever made them. Stateless. */
public object MeshRework {
    /** As the other, with nobody listening. */
    @JvmStatic
    public fun improve(mesh: TriMesh): TriMesh = improve(mesh, ProgressMonitor.NONE)

    /**
     * The mesh with better elements of about the same sizes: nodes inside move, come and go; nodes and edges of the boundary and
     * of embedded lines stay exactly as they are, but for their numbers. The mesh itself, if no better one is found by
     * smallest or mean quality.
     *
     * @param monitor hears of the progress, as stage [Stage.IMPROVE], and may cancel.
     * @throws IllegalArgumentException if [mesh] is not valid by [MeshCheck].
     * @throws MeshingCancelledException if the monitor cancels.
     */
    @JvmStatic
    public fun improve(mesh: TriMesh, monitor: ProgressMonitor): TriMesh {
        MeshCheck.requireValid(mesh)
        val fixedFirst = mesh.renumbered(fixedFirst(mesh))
        val mutable = mutable(fixedFirst)
        val tolerance = MeshOptions.DEFAULT.smoothingTolerance
        MeshImprovement.improve(mutable, Strategy.ROBUST, tolerance) {
            if (!monitor.update(Stage.IMPROVE, it)) throw MeshingCancelledException()
        }
        val elements = mutable.elements.copyOf(3 * mutable.elementCount)
        val parts = MeshParts(
            mesh.regions, regions(fixedFirst, mutable.nodeCount, elements), fixedFirst.parts.points, fixedFirst.parts.pointTags,
        )
        val improved = TriMeshFactory.of(
            mutable.xy.copyOf(2 * mutable.nodeCount), elements, fixedFirst.edges, fixedFirst.edgeTags, mesh.tags, parts,
        )
        val before = QualityReport.of(mesh)
        val after = QualityReport.of(improved)
        val isBetter = after.minQuality > before.minQuality || after.meanQuality > before.meanQuality
        return if (isBetter) improved else mesh
    }

    /** As the other, with straight boundaries. */
    @JvmStatic
    public fun refine(mesh: TriMesh): TriMesh = refine(mesh, EdgeMiddles.STRAIGHT)

    /**
     * Each element divided into four by the middles of its edges. The nodes keep their numbers; those in the middles come after them.
     *
     * @param middles where the new nodes of tagged edges lie; those of others lie halfway.
     * @throws IllegalArgumentException if [mesh] is not valid by [MeshCheck].
     */
    @JvmStatic
    public fun refine(mesh: TriMesh, middles: EdgeMiddles): TriMesh {
        MeshCheck.requireValid(mesh)
        return UniformRefinement(mesh, middles).refined()
    }

    /** As the other, with straight boundaries. */
    @JvmStatic
    public fun secondOrder(mesh: TriMesh): QuadraticMesh = secondOrder(mesh, EdgeMiddles.STRAIGHT)

    /**
     * The mesh with elements of six nodes, all nodes renumbered for a small bandwidth.
     *
     * @param middles where the middles of tagged edges lie, such as a `ShapeMiddles`; those of others lie halfway. A middle that
     *   would fold an element is moved towards the straight one, which [QuadraticMesh.straightenedEdgeCount] tells.
     * @throws IllegalArgumentException if [mesh] is not valid by [MeshCheck].
     */
    @JvmStatic
    public fun secondOrder(mesh: TriMesh, middles: EdgeMiddles): QuadraticMesh =
        Numbering.renumber(QuadraticMesh.of(mesh, middles), NumberingMethod.BEST)

    /** Regions of new elements between the tagged edges of [mesh]. */
    private fun regions(mesh: TriMesh, nodeCount: Int, elements: IntArray): IntArray {
        if (mesh.regions.size == 1) return IntArray(0)
        val before = TaggedSides(mesh)
        val flood = RegionFlood(
            MeshTopology.neighbours(nodeCount, elements), TaggedSides(nodeCount, elements, 3, mesh.edges, 2), mesh.taggedEdgeCount,
        )
        return flood.regions(
            { mesh.regionOf(before.leftOf(it) / 3) },
            { mesh.regionOf(mesh.neighbourOf(before.leftOf(it) / 3, before.leftOf(it) % 3)) },
        )
    }

    /** New numbers with which given nodes come before others. */
    private fun fixedFirst(mesh: TriMesh): IntArray {
        val isFixed = BooleanArray(mesh.nodeCount) { mesh.kindOf(it) != NodeKind.INTERIOR }
        var fixed = 0
        var free = isFixed.count { it }
        return IntArray(mesh.nodeCount) { if (isFixed[it]) fixed++ else free++ }
    }

    private fun mutable(mesh: TriMesh): MutableMesh {
        val fixed = (0 until mesh.nodeCount).count { mesh.kindOf(it) != NodeKind.INTERIOR }
        val embedded = mesh.edges.copyOfRange(2 * mesh.boundaryEdgeCount, mesh.edges.size)
        val result = MutableMesh(mesh.xy.copyOf(), fixed, sizes(mesh), mesh.elementCount, EdgeSet(embedded))
        result.nodeCount = mesh.nodeCount
        for (t in 0 until mesh.elementCount) result.addElement(mesh.nodeOf(t, 0), mesh.nodeOf(t, 1), mesh.nodeOf(t, 2))
        for (half in 0 until 3 * mesh.elementCount) {
            val other = mesh.neighbourOf(half / 3, half % 3)
            if (other < half / 3) continue
            val start = result.elements[3 * (half / 3) + (half % 3 + 1) % 3]
            result.link(half, (3 * other..3 * other + 2).first { result.elements[it] == start })
        }
        return result
    }

    /** Mean length of the edges at each node. */
    private fun sizes(mesh: TriMesh): DoubleArray {
        val sums = DoubleArray(mesh.nodeCount)
        val counts = IntArray(mesh.nodeCount)
        val edges = mesh.edgeNodes()
        for (e in 0 until edges.size / 2) {
            val a = edges[2 * e]
            val b = edges[2 * e + 1]
            val length = Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a))
            for (node in intArrayOf(a, b)) {
                sums[node] += length
                counts[node]++
            }
        }
        return DoubleArray(mesh.nodeCount) { if (counts[it] == 0) 1.0 else sums[it] / counts[it] }
    }
}
