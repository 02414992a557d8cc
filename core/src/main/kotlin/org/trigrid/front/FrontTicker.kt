package org.trigrid.front

import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage

/** Tells the monitor how far the front has come, every few thousand elements, and ends the run when it says so. */
internal class FrontTicker(private val monitor: ProgressMonitor, private val expectedElements: Double) {
    private var due = INTERVAL

    fun tick(elementCount: Int) {
        if (elementCount < due) return
        due = elementCount + INTERVAL
        if (!monitor.update(Stage.FRONT, Math.min(elementCount / expectedElements, 1.0))) throw MeshingCancelledException()
    }

    private companion object {
        const val INTERVAL = 4096
    }
}
