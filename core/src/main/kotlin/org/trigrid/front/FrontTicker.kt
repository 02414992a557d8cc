package org.trigrid.front

import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage

/** Tells the monitor how far the front has come, every few dozen edges tried, and ends the run when it says so. */
internal class FrontTicker(private val monitor: ProgressMonitor, private val expectedElements: Double) {
    private var tries = 0

    /** An edge was tried; there are [elementCount] elements now. */
    fun tick(elementCount: Int) {
        if (++tries % INTERVAL != 0) return
        if (!monitor.update(Stage.FRONT, Math.min(elementCount / expectedElements, 1.0))) throw MeshingCancelledException()
    }

    private companion object {
        const val INTERVAL = 32
    }
}
