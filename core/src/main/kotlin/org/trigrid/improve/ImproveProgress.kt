package org.trigrid.improve

/** Spreads the stages of the improvement, of known shares of the work, over the progress from 0 to 1. */
internal class ImproveProgress(private val report: (Double) -> Unit) {
    private var from = 0.0
    private var to = 0.0
    private var reached = 0.0
    private var steps = 0

    /** Ends the stage before and begins one that takes [share] of the whole work. */
    fun stage(share: Double) {
        from = to
        to = Math.min(1.0, from + share)
        tell(from)
    }

    /** Step [i] of [count] of the stage; reports every few hundred steps. */
    fun tick(i: Int, count: Int) {
        if (i and TICK_MASK == 0 && i < count) tell(from + (to - from) * i / count)
    }

    /** A step of work whose share is not known; asks every thousand steps whether to go on. */
    fun pass() {
        if (++steps and PASS_MASK == 0) report(reached)
    }

    private fun tell(part: Double) {
        reached = part
        report(part)
    }

    fun finish() {
        to = 1.0
        report(1.0)
    }

    private companion object {
        const val TICK_MASK = 255
        const val PASS_MASK = 1023
    }
}
