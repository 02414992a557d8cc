package org.trigrid.improve

import org.trigrid.MeshOptions
import org.trigrid.Strategy
import org.trigrid.mesh.MutableMesh

/** Improves the raw mesh of the front as befits the strategy that made it. */
internal object MeshImprovement {
    /**
     * Improves [mesh] in place and compacts it.
     *
     * @param report hears of the progress, from 0 to 1, and may throw to end the work.
     */
    @JvmStatic
    fun improve(mesh: MutableMesh, options: MeshOptions, report: (Double) -> Unit) {
        when (options.strategy) {
            Strategy.CLASSIC -> {
                LaplacianSmoother(mesh, options.smoothingTolerance, isGuarded = true).run(report)
                mesh.compact()
            }
            Strategy.ROBUST -> MeshImprover(mesh, options.smoothingTolerance).run(report)
        }
    }
}
