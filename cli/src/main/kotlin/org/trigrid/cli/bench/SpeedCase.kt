package org.trigrid.cli.bench

import org.trigrid.diagnostics.Stage
import java.util.Locale

/** All runs on one domain. */
internal class SpeedCase(
    val family: BenchmarkFamily,
    val size: Double,
    val boundaryNodes: Int,
    val runs: List<MeshRun>,
    /** Null where a peer failed or took too long. */
    val peers: Map<Peer, PeerRun?>,
) {
    val name: String get() = name(family, size)
    val elements: Int get() = runs.first().elements
    val least: Double get() = runs.minOf { it.threadSeconds }
    val median: Double get() = median(runs.map { it.threadSeconds })
    val processMedian: Double get() = median(runs.map { it.processSeconds })

    /** Elements per second in the best run. */
    val rate: Double get() = elements / least

    /** Median CPU seconds of [stage]. */
    fun secondsOf(stage: Stage): Double = median(runs.map { it.secondsOf(stage) })

    /** Elements per second of [peer] in its best run, or NaN. */
    fun rateOf(peer: Peer): Double = peers[peer]?.let { it.elements / it.seconds.min() } ?: Double.NaN

    companion object {
        /** As `coast 1e5`. */
        fun name(family: BenchmarkFamily, size: Double): String {
            val text = "%.1e".format(Locale.ROOT, size).replace(".0e", "e").replace(Regex("e\\+0*"), "e")
            return family.name.lowercase() + " " + text
        }

        fun median(values: List<Double>): Double {
            val sorted = values.sorted()
            val half = sorted.size / 2
            return if (sorted.size % 2 == 1) sorted[half] else 0.5 * (sorted[half - 1] + sorted[half])
        }
    }
}
