package org.trigrid

import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage

/** Times the stages of a run and turns each stage's own progress into that of the whole, which never falls. */
internal class StageClock(
    private val monitor: ProgressMonitor,
    /** Nanoseconds between two questions to the monitor, at least; 0 passes every one on. */
    private val rest: Long = REST,
) : ProgressMonitor {
    val seconds = DoubleArray(Stage.entries.size)
    private var stage = Stage.CHECK
    private var since = System.nanoTime()
    private var told = 0.0
    private var askedAt = since

    /** Ends the stage before and begins [next]. */
    fun begin(next: Stage) {
        close()
        stage = next
        if (!tell(next, 0.0)) throw MeshingCancelledException()
    }

    fun end() {
        close()
        if (!monitor.update(stage, 1.0)) throw MeshingCancelledException()
    }

    /**
     * Stages ask as often as a cancelled run should end soon; the monitor is not troubled more than it can bear. What a stage
     * before has made, as the sizes, may ask later on: the monitor is told the stage of the run.
     */
    override fun update(stage: Stage, fraction: Double): Boolean =
        System.nanoTime() - askedAt < rest || tell(this.stage, if (stage == this.stage) fraction else 0.0)

    private fun tell(stage: Stage, fraction: Double): Boolean {
        askedAt = System.nanoTime()
        val i = stage.ordinal
        told = Math.max(told, STARTS[i] + fraction * (STARTS[i + 1] - STARTS[i]))
        return monitor.update(stage, told)
    }

    private fun close() {
        val now = System.nanoTime()
        seconds[stage.ordinal] += (now - since) / 1e9
        since = now
    }

    private companion object {
        const val REST = 4_000_000L

        /** Share of the whole at which each stage begins, by the time it takes on large domains. */
        val STARTS = doubleArrayOf(0.0, 0.03, 0.06, 0.4, 0.85, 1.0)
    }
}
