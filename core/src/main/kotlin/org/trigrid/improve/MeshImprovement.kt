package org.trigrid.improve

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.Stage
import org.trigrid.front.Strategy
import org.trigrid.mesh.MeshLocality
import org.trigrid.mesh.MutableMesh
import org.trigrid.parallel.Crew

/** Improves the raw mesh of the front as befits the strategy that made it. */
internal object MeshImprovement {
    /**
     * Improves [mesh] in place and compacts it. A large mesh gets its free nodes and elements in an order of its own.
     *
     * @param crew shares the work on a mesh of more than one part; the result is the same for any.
     * @param smoothingTolerance part of a node's size; smoothing stops when no node moves by more.
     * @param report hears of the progress, from 0 to 1, and may throw to end the work.
     */
    @JvmStatic
    @JvmOverloads
    fun improve(
        mesh: MutableMesh, strategy: Strategy, smoothingTolerance: Double, crew: Crew = Crew.CALLER, report: (Double) -> Unit,
    ) {
        when (strategy) {
            Strategy.CLASSIC -> {
                LaplacianSmoother(mesh, smoothingTolerance, isGuarded = true).run(report)
                mesh.compact()
            }
            Strategy.ROBUST -> {
                if (mesh.elementCount >= MeshLocality.LARGE) MeshLocality.arrange(mesh, checkpoint(report))
                val parts = Math.round(mesh.elementCount / PART.toDouble()).toInt()
                if (parts < 2) {
                    MeshImprover(mesh, smoothingTolerance, report).run()
                } else {
                    DividedImprovement(mesh, smoothingTolerance, crew, report).run(parts)
                }
            }
        }
    }

    /** Elements of a part, about; a mesh of less than one and a half is not divided. */
    private const val PART = 100_000

    private fun checkpoint(report: (Double) -> Unit) = Checkpoint(
        { _, _ ->
            report(0.0)
            true
        },
        Stage.IMPROVE,
    )
}
