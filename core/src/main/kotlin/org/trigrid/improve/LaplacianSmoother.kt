package org.trigrid.improve

import org.trigrid.mesh.MutableMesh

/**
 * The paper's smoothing (Naji, equations 2 to 5): each free node goes to the mean of its neighbours, again and again until
 * the largest move r_max is below a tolerance. The connectivity stays as it is.
 *
 * The paper leaves open whether a node sees its neighbours' old or new places; here it sees the new ones (Gauss-Seidel),
 * which needs fewer sweeps. Its tolerance is a length; here it is a part of the node's wanted length, so that units do not
 * matter. Its method may invert elements at re-entrant corners; the guard prevents that.
 */
internal class LaplacianSmoother(
    private val mesh: MutableMesh,
    /** The smoothing ends when no node moves by more than this part of its wanted length. */
    private val tolerance: Double,
    /**
     * Whether a move is shortened, or left out, when it would make an element negative or the worst element around the
     * node worse than [FAIR]; without the guard, the result may be no valid mesh.
     */
    private val isGuarded: Boolean,
) {
    private val connectivity = Connectivity(mesh)
    private val star = Star()

    /** Smooths the mesh. [report] hears of the progress, from 0 to 1, and may throw to end the work. */
    fun run(report: (Double) -> Unit) {
        val progress = ImproveProgress(report)
        for (sweep in 0 until MOST_SWEEPS) {
            progress.stage(1.0 / MOST_SWEEPS)
            if (sweep(progress) < tolerance) break
        }
        progress.finish()
    }

    /** One sweep; returns r_max relative to the nodes' wanted lengths, equation (5). */
    private fun sweep(progress: ImproveProgress): Double {
        var largest = 0.0
        val count = mesh.nodeCount
        for (n in mesh.fixedNodeCount until count) {
            progress.tick(n, count)
            if (connectivity.outgoing[n] < 0) continue
            star.gather(connectivity, n)
            val oldX = star.x
            val oldY = star.y
            if (isGuarded) moveGuarded() else star.centre()
            mesh.xy[2 * n] = star.x
            mesh.xy[2 * n + 1] = star.y
            val r = Math.sqrt((star.x - oldX) * (star.x - oldX) + (star.y - oldY) * (star.y - oldY))
            largest = Math.max(largest, r / mesh.sizes[n])
        }
        return largest
    }

    private fun moveGuarded() {
        val oldX = star.x
        val oldY = star.y
        val least = Math.max(Math.min(star.minQuality(), FAIR), Star.SURELY_POSITIVE)
        star.centre()
        for (halving in 0..MOST_HALVINGS) {
            if (star.minQuality() >= least) return
            star.x = 0.5 * (oldX + star.x)
            star.y = 0.5 * (oldY + star.y)
        }
        star.x = oldX
        star.y = oldY
    }

    private companion object {
        /** A move may lower the least q around a node down to this. */
        const val FAIR = 0.75
        const val MOST_HALVINGS = 3
        const val MOST_SWEEPS = 50
    }
}
