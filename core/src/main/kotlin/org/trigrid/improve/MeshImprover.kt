package org.trigrid.improve

import org.trigrid.mesh.MutableMesh
import org.trigrid.spacing.SizeField

/** Turns the raw mesh of the front into a good one. */
internal class MeshImprover(
    private val mesh: MutableMesh,
    @Suppress("unused") private val sizes: SizeField?,
    private val tolerance: Double,
) {
    fun run(progress: (Double) -> Unit) {
        val connectivity = Connectivity(mesh)
        val ideal = IdealValence(mesh)
        val changes = Changes(mesh)
        val flipper = Flipper(connectivity, ideal, changes)
        val collapser = Collapser(connectivity, ideal, changes, flipper)
        val splitter = Splitter(connectivity, ideal, changes, flipper)
        val smoother = Smoother(connectivity, changes, tolerance)
        changes.touchAll()
        flipper.pushAll()
        flipper.run()
        for (round in 0 until ROUNDS) {
            for (n in mesh.fixedNodeCount until mesh.nodeCount) {
                if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.SURGERY)) continue
                if (collapser.tryNode(n) || splitter.tryNode(n)) flipper.run()
            }
            for (sweep in 0 until SWEEPS) if (smoother.sweep() == 0) break
            flipper.pushAll()
            flipper.run()
            progress(0.9 * (round + 1) / ROUNDS)
        }
        flipper.byQuality = true
        flipper.pushAll()
        flipper.run()
        for (sweep in 0 until LAST_SWEEPS) if (smoother.sweep() == 0) break
        flipper.pushAll()
        flipper.run()
        for (sweep in 0 until LAST_SWEEPS) if (smoother.sweep() == 0) break
        for (round in 0 until WORST) {
            smoother.worst(WORST_Q, WORST_SWEEPS)
            flipper.pushAll()
            if (flipper.run() == 0) break
        }
        mesh.compact()
        progress(1.0)
    }

    companion object {
        @JvmField var ROUNDS = 4
        @JvmField var SWEEPS = 3
        @JvmField var LAST_SWEEPS = 5
        @JvmField var WORST = 3
        @JvmField var WORST_SWEEPS = 6
        @JvmField var WORST_Q = 0.8
    }
}
