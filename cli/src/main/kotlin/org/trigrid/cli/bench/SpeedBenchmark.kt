package org.trigrid.cli.bench

import org.trigrid.MeshOptions

/** Measures the mesher, warm and in this process, and the peers in turn with it. */
internal class SpeedBenchmark(
    private val options: MeshOptions,
    private val runs: Int,
    private val peers: PeerProgram?,
    /** Hears what is being measured. */
    private val tell: (String) -> Unit,
) {
    /** Lets the compiler see domains of every kind before anything is measured. */
    fun warmUp(seconds: Double) {
        tell("warming up")
        val until = System.nanoTime() + (seconds * 1e9).toLong()
        var i = 0
        while (System.nanoTime() < until) {
            val family = WARM_FAMILIES[i++ % WARM_FAMILIES.size]
            MeshRun.of(BenchmarkDomains.create(family, WARM_ELEMENTS), options)
        }
    }

    /** Half of our runs, the peers, the other half: a machine that slows down meanwhile slows all alike. */
    fun measure(family: BenchmarkFamily, size: Double): SpeedCase {
        val domain = BenchmarkDomains.create(family, size)
        val name = SpeedCase.name(family, size)
        tell("$name: TriGrid")
        // Short runs are repeated more often: they cost little and scatter more.
        val ours = if (size < SHORT) SHORT_FACTOR * runs else runs
        MeshRun.of(domain, options)
        val first = List((ours + 1) / 2) { MeshRun.of(domain, options) }
        val others = peers?.versions?.keys.orEmpty().associateWith { peer ->
            tell("$name: ${peer.title}")
            peers?.run(peer, domain, peerRuns(size), null)
        }
        val second = List(ours / 2) { MeshRun.of(domain, options) }
        return SpeedCase(family, size, domain.nodeCount, first + second, others)
    }

    private fun peerRuns(size: Double) = if (size < SHORT) 5 else if (size < LONG) 2 else 1

    private companion object {
        const val WARM_ELEMENTS = 2e4
        val WARM_FAMILIES = BenchmarkFamily.entries - BenchmarkFamily.SIEVE
        const val SHORT = 5e4
        const val LONG = 5e5
        const val SHORT_FACTOR = 4
    }
}
