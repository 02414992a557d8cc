package org.trigrid.cli.batch

import org.trigrid.cli.Terminal
import java.util.Locale

/**
 * How far a batch has come: counts for its last line, and on a terminal a bar with the rate and the time left. Used by several
 * threads.
 *
 * @param clock nanoseconds, from any origin.
 */
internal class BatchProgress(
    private val terminal: Terminal,
    private val fileCount: Int,
    private val clock: () -> Long = System::nanoTime,
) {
    private val start = clock()
    private var lastDrawn = start
    private var isShown = false
    private var filesDone = 0.0

    var meshes = 0
        private set
    var elements = 0L
        private set
    var failed = 0
        private set
    var skipped = 0
        private set

    val seconds: Double get() = (clock() - start) / 1e9

    /** @param share of its file that the mesh was. */
    @Synchronized
    fun done(share: Double, elementCount: Int) {
        meshes++
        elements += elementCount
        advance(share)
    }

    @Synchronized
    fun skip(share: Double) {
        skipped++
        advance(share)
    }

    /** @param lines what went wrong, for standard error. */
    @Synchronized
    fun fail(share: Double, lines: String) {
        failed++
        clear()
        terminal.err.print(lines)
        advance(share)
    }

    @Synchronized
    fun close() = clear()

    private fun advance(share: Double) {
        filesDone += share
        val now = clock()
        if (!terminal.showsProgress || now - start < PATIENCE || now - lastDrawn < INTERVAL) return
        lastDrawn = now
        isShown = true
        terminal.err.print("\r" + line((now - start) / 1e9) + "\u001B[K")
        terminal.err.flush()
    }

    private fun line(seconds: Double): String {
        val fraction = (filesDone / fileCount).coerceIn(0.0, 1.0)
        val done = (fraction * WIDTH).toInt()
        val left = if (fraction > 0) seconds * (1 - fraction) / fraction else 0.0
        val bar = "#".repeat(done) + "-".repeat(WIDTH - done)
        return String.format(
            Locale.ROOT, "[%s] %3.0f %% %d meshes, %.1f/s, %d failed, %s left",
            bar, 100 * fraction, meshes, meshes / seconds, failed, duration(left),
        )
    }

    private fun duration(seconds: Double): String {
        val whole = Math.round(seconds)
        return when {
            whole < 60 -> "$whole s"
            whole < 3600 -> "${whole / 60} min ${whole % 60} s"
            else -> "${whole / 3600} h ${whole / 60 % 60} min"
        }
    }

    private fun clear() {
        if (isShown) terminal.err.print("\r\u001B[K")
        terminal.err.flush()
        isShown = false
    }

    private companion object {
        const val PATIENCE = 500_000_000L
        const val INTERVAL = 100_000_000L
        const val WIDTH = 30
    }
}
