package org.trigrid.diagnostics

/**
 * Where long work asks whether to go on: loops call [pass] at each step, and the monitor is asked once in a thousand of
 * them, so that a run can be cancelled within some hundredths of a second wherever it is.
 */
internal class Checkpoint(private val monitor: ProgressMonitor, private val stage: Stage) {
    private var steps = 0
    private var fraction = 0.0

    /** A step of the work was done, of a microsecond or so. @throws MeshingCancelledException if the run is to end. */
    fun pass() {
        if (++steps and MASK == 0) ask()
    }

    /** As [pass], for work that takes as long as [count] steps. */
    fun pass(count: Int) {
        val before = steps
        steps += count
        if ((before xor steps) and MASK.inv() != 0) ask()
    }

    /** Asks at once, before or after a longer piece of work. @throws MeshingCancelledException if the run is to end. */
    fun ask() {
        if (!monitor.update(stage, fraction)) throw MeshingCancelledException()
    }

    /** [part] of the stage is done, 0..1. @throws MeshingCancelledException if the run is to end. */
    fun reach(part: Double) {
        fraction = Math.max(fraction, part)
        ask()
    }

    companion object {
        private const val MASK = 1023

        /** A checkpoint of a run that nobody listens to. */
        fun unheard(): Checkpoint = Checkpoint(ProgressMonitor.NONE, Stage.CHECK)
    }
}
