package org.trigrid.improve

import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshLocality
import org.trigrid.mesh.MutableMesh

/** Improves the raw mesh of the front as befits the strategy that made it. */
internal object MeshImprovement {
    /**
     * Improves [mesh] in place and compacts it. A large mesh gets its free nodes and elements in an order of its own.
     *
     * @param smoothingTolerance part of a node's size; smoothing stops when no node moves by more.
     * @param report hears of the progress, from 0 to 1, and may throw to end the work.
     */
    @JvmStatic
    fun improve(mesh: MutableMesh, strategy: Strategy, smoothingTolerance: Double, report: (Double) -> Unit) {
        when (strategy) {
            Strategy.CLASSIC -> {
                LaplacianSmoother(mesh, smoothingTolerance, isGuarded = true).run(report)
                mesh.compact()
            }
            Strategy.ROBUST -> {
                if (mesh.elementCount >= MeshLocality.LARGE) MeshLocality.arrange(mesh)
                MeshImprover(mesh, smoothingTolerance).run(report)
            }
        }
    }
}
