package org.trigrid.cli

/** Wall time of what the command itself does round the mesher. */
internal class RunClock {
    private val start = System.nanoTime()

    var readSeconds: Double = 0.0
        private set

    var writeSeconds: Double = 0.0
        private set

    /** Making elements of second order. */
    var orderSeconds: Double = 0.0
        private set

    /** From the start to the end of what was timed last. */
    var totalSeconds: Double = 0.0
        private set

    fun <T> reading(work: () -> T): T = timed(work) { readSeconds += it }

    fun <T> ordering(work: () -> T): T = timed(work) { orderSeconds += it }

    fun <T> writing(work: () -> T): T = timed(work) { writeSeconds += it }

    private fun <T> timed(work: () -> T, add: (Double) -> Unit): T {
        val from = System.nanoTime()
        val result = work()
        val to = System.nanoTime()
        add((to - from) / NANOSECONDS)
        totalSeconds = (to - start) / NANOSECONDS
        return result
    }

    private companion object {
        const val NANOSECONDS = 1e9
    }
}
