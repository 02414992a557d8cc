package org.trigrid.reliability

import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.spacing.Sizes
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.domain.Domain
import java.lang.management.ManagementFactory
import java.util.TreeMap

/** Measures how long a run goes on without asking its monitor, and where: what it takes to cancel at the worst moment. */
internal object CancelGaps {
    private class Meter : ProgressMonitor {
        @Volatile
        var last = System.nanoTime()
        private var before = 0.0
        private val processor = ManagementFactory.getThreadMXBean()
        private var lastCpu = processor.currentThreadCpuTime
        val longestCpu = LongArray(Stage.entries.size)
        val longest = LongArray(Stage.entries.size)
        val calls = IntArray(Stage.entries.size)
        var fell = false

        override fun update(stage: Stage, fraction: Double): Boolean {
            val now = System.nanoTime()
            longest[stage.ordinal] = Math.max(longest[stage.ordinal], now - last)
            val cpu = processor.currentThreadCpuTime
            longestCpu[stage.ordinal] = Math.max(longestCpu[stage.ordinal], cpu - lastCpu)
            lastCpu = cpu
            calls[stage.ordinal]++
            fell = fell || fraction < before
            before = fraction
            last = System.nanoTime()
            return true
        }

        fun forget() {
            last = System.nanoTime()
            lastCpu = processor.currentThreadCpuTime
        }
    }

    /** Samples the stack of [thread] while [meter] has not been asked for long. */
    private class Watcher(private val meter: Meter, private val thread: Thread, private val samples: TreeMap<String, Int>) : Thread() {
        init {
            isDaemon = true
        }

        override fun run() {
            while (!isInterrupted) {
                try {
                    sleep(2)
                } catch (_: InterruptedException) {
                    return
                }
                if (System.nanoTime() - meter.last < LONG) continue
                val frames = thread.stackTrace.filter { it.className.startsWith("org.trigrid") }.take(3)
                val place = frames.joinToString(" < ") { it.className.substringAfterLast('.') + "." + it.methodName + ":" + it.lineNumber }
                samples.merge(place, 1, Int::plus)
            }
        }
    }

    private const val LONG = 20_000_000L

    /** A square of side 1 with [n] segments a side. */
    fun square(n: Int): Domain = Domain.of(RandomLoops.subdivided(RandomLoops.square(0.0, 0.0, 1.0), n))

    /** A wavy ring of [n] nodes. */
    fun ring(n: Int): Domain = Domain.of(
        DoubleArray(2 * n) {
            val angle = 2 * Math.PI * (it / 2) / n
            val radius = 1 + 0.3 * StrictMath.sin(9 * angle) + 0.01 * StrictMath.sin(1001 * angle)
            radius * if (it % 2 == 0) StrictMath.cos(angle) else StrictMath.sin(angle)
        },
    )

    /** `CancelGaps square|ring N [TIMES]`: the longest gap in each stage, in milliseconds, of the last of so many runs. */
    @JvmStatic
    fun main(args: Array<String>) {
        val isRing = args[0] == "ring"
        val domain = if (isRing) ring(args[1].toInt()) else square(args[1].toInt())
        val options = MeshOptions.builder()
        if (isRing) options.sizes(Sizes.GRADE).gradation(1.0)
        repeat(args.getOrNull(2)?.toInt() ?: 1) {
            val meter = Meter()
            val samples = TreeMap<String, Int>()
            val watcher = Watcher(meter, Thread.currentThread(), samples)
            watcher.start()
            meter.forget()
            val result = MeshGenerator.generate(domain, options.build(), meter)
            watcher.interrupt()
            watcher.join()
            val report = result.report
            println("${report.nodeCount} nodes, ${report.elementCount} elements, ${report.totalSeconds} s; progress fell: ${meter.fell}")
            for (stage in Stage.entries) {
                val longest = meter.longest[stage.ordinal] / 1_000_000
                println("  $stage ${report.seconds(stage)} s, ${meter.calls[stage.ordinal]} calls, longest gap $longest ms, ${meter.longestCpu[stage.ordinal] / 1_000_000} ms of the thread's own")
            }
            samples.entries.sortedByDescending { it.value }.take(40).forEach { println("    ${it.value} ${it.key}") }
        }
    }
}
