package org.trigrid.front

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.domain.Domain
import org.trigrid.mesh.MutableMesh
import org.trigrid.spacing.SizeField

/** Fills a valid domain with elements by the advancing front technique. */
internal object FrontMesher {
    /**
     * @param expectedElements estimate that sizes the arrays, the progress and the bound on the work.
     * @param monitor hears the stage FRONT from 0 to 1.
     * @param listener hears of every element, or null.
     */
    @JvmOverloads
    fun mesh(
        domain: Domain,
        sizes: SizeField,
        strategy: Strategy,
        expectedElements: Double,
        monitor: ProgressMonitor,
        listener: FrontListener? = null,
    ): FrontResult {
        val state = FrontState(domain, sizes, expectedElements, Checkpoint(monitor, Stage.FRONT))
        val ticker = FrontTicker(monitor, expectedElements)
        val advancer = when (strategy) {
            Strategy.CLASSIC -> ClassicAdvancer(domain, state, ticker)
            Strategy.ROBUST -> RobustAdvancer(state, ticker)
        }
        advancer.listener = listener
        advancer.run()
        PointInsertion(state.mesh).insert(domain.segmentNodeCount until domain.nodeCount)
        return FrontResult(state.mesh, advancer.fallbacks)
    }
}

/** The raw mesh of the front. */
internal class FrontResult(
    val mesh: MutableMesh,
    /** Elements made by the constrained-Delaunay way out. */
    val fallbacks: Int,
)
