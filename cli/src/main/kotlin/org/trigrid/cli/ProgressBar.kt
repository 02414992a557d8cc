package org.trigrid.cli

import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import java.io.PrintStream
import java.util.Locale

/**
 * A bar on the terminal for work that takes longer than half a second, and the way by which Ctrl-C reaches the mesher.
 *
 * @param clock nanoseconds, from any origin.
 */
internal class ProgressBar(
    private val terminal: Terminal,
    private val cancellation: Cancellation,
    private val clock: () -> Long = System::nanoTime,
) : ProgressMonitor, AutoCloseable {
    private val err: PrintStream get() = terminal.err
    private val start = clock()
    private var lastDrawn = start
    private var isShown = false

    override fun update(stage: Stage, fraction: Double): Boolean {
        if (terminal.showsProgress) draw(stage, fraction)
        return !cancellation.isRequested
    }

    /** Takes the bar off the terminal. */
    override fun close() {
        if (isShown) err.print(CLEAR_LINE)
        err.flush()
        isShown = false
    }

    private fun draw(stage: Stage, fraction: Double) {
        val now = clock()
        if (now - start < PATIENCE || now - lastDrawn < INTERVAL) return
        lastDrawn = now
        isShown = true
        val done = (fraction * WIDTH).toInt().coerceIn(0, WIDTH)
        val bar = "#".repeat(done) + "-".repeat(WIDTH - done)
        err.print(String.format(Locale.ROOT, "\r[%s] %3.0f %% %-9s", bar, fraction * 100, stage.name.lowercase(Locale.ROOT)))
        err.flush()
    }

    private companion object {
        const val PATIENCE = 500_000_000L
        const val INTERVAL = 100_000_000L
        const val WIDTH = 40
        const val CLEAR_LINE = "\r\u001B[K"
    }
}
