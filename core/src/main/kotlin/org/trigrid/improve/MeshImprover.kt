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
        var t0 = now()
        val connectivity = Connectivity(mesh)
        val ideal = IdealValence(mesh)
        val changes = Changes(mesh)
        val flipper = Flipper(connectivity, ideal, changes)
        val collapser = Collapser(connectivity, ideal, changes, flipper)
        val splitter = Splitter(connectivity, ideal, changes, flipper)
        val smoother = Smoother(connectivity, changes, tolerance)
        changes.touchAll()
        t0 = lap(0, t0)
        flipper.pushAll()
        flipper.run()
        t0 = lap(1, t0)
        for (round in 0 until ROUNDS) {
            for (n in mesh.fixedNodeCount until mesh.nodeCount) {
                if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.SURGERY)) continue
                if (collapser.tryNode(n) || splitter.tryNode(n)) flipper.run()
            }
            t0 = lap(2, t0)
            for (sweep in 0 until SWEEPS) if (smoother.sweep() == 0) break
            t0 = lap(3, t0)
            flipper.pushAll()
            flipper.run()
            t0 = lap(4, t0)
            progress(0.9 * (round + 1) / ROUNDS)
        }
        if (TRIALS > 0) {
            val trial = Trial(connectivity, ideal, changes)
            for (k in 0 until TRIALS) {
                trial.pass()
                t0 = lap(5, t0)
                smoother.sweep()
                t0 = lap(6, t0)
            }
            tried += trial.tried
            done += trial.done
        }
        flipper.byQuality = true
        flipper.pushAll()
        flipper.run()
        t0 = lap(7, t0)
        for (sweep in 0 until LAST_SWEEPS) if (smoother.sweep() == 0) break
        t0 = lap(8, t0)
        flipper.pushAll()
        flipper.run()
        t0 = lap(7, t0)
        for (sweep in 0 until LAST_SWEEPS) if (smoother.sweep() == 0) break
        t0 = lap(8, t0)
        for (round in 0 until WORST) {
            smoother.worst(WORST_Q, WORST_SWEEPS)
            flipper.pushAll()
            if (flipper.run() == 0) break
        }
        t0 = lap(9, t0)
        mesh.compact()
        t0 = lap(0, t0)
        progress(1.0)
    }
    private fun now() = System.nanoTime()
    private fun lap(i: Int, from: Long): Long { val t = now(); laps[i] += t - from; return t }

    companion object {
        @JvmField val laps = LongArray(10)
        val names = listOf("init", "flip0", "surgery", "smooth", "reflip", "trial", "tsmooth", "qflip", "lastsm", "worst")
        @JvmField var TRIALS = 2
        @JvmField var tried = 0
        @JvmField var done = 0
        @JvmField var ROUNDS = 4
        @JvmField var SWEEPS = 3
        @JvmField var LAST_SWEEPS = 5
        @JvmField var WORST = 3
        @JvmField var WORST_SWEEPS = 6
        @JvmField var WORST_Q = 0.85
    }
}
