package org.trigrid.cli.bench

import com.sun.management.OperatingSystemMXBean
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.MeshResult
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.domain.Domain
import java.lang.management.ManagementFactory

/** One run of the mesher with what it cost. */
internal class MeshRun private constructor(
    val result: MeshResult,
    /** CPU seconds of the thread that meshed; seconds of the clock where several threads did. */
    val threadSeconds: Double,
    /** CPU seconds of the whole process meanwhile: with the collector and the compiler at their work. */
    val processSeconds: Double,
    /** As [threadSeconds], by stage. */
    private val stageSeconds: DoubleArray,
) {
    val elements: Int get() = result.report.elementCount

    fun secondsOf(stage: Stage): Double = stageSeconds[stage.ordinal]

    /** Reads the thread's clock whenever the mesher goes on to another stage. */
    private class StageMeter(private val nanos: () -> Long) : ProgressMonitor {
        val seconds = DoubleArray(Stage.entries.size)
        private var stage = Stage.CHECK
        private var since = nanos()

        override fun update(stage: Stage, fraction: Double): Boolean {
            if (stage != this.stage) close(stage)
            return true
        }

        fun close(next: Stage) {
            val now = nanos()
            seconds[stage.ordinal] += (now - since) / 1e9
            stage = next
            since = now
        }
    }

    companion object {
        fun of(domain: Domain, options: MeshOptions): MeshRun {
            val processBefore = system.processCpuTime
            val nanos: () -> Long = if (options.threads > 1) System::nanoTime else threads::getCurrentThreadCpuTime
            val before = nanos()
            val meter = StageMeter(nanos)
            val result = MeshGenerator.generate(domain, options, meter)
            meter.close(Stage.RENUMBER)
            val thread = (nanos() - before) / 1e9
            return MeshRun(result, thread, (system.processCpuTime - processBefore) / 1e9, meter.seconds)
        }

        private val system = ManagementFactory.getOperatingSystemMXBean() as OperatingSystemMXBean
        private val threads = ManagementFactory.getThreadMXBean()
    }
}
