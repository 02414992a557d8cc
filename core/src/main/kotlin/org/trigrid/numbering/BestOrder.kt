package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/** Keeps the best of the orders it is offered: the lowest half-bandwidth, then the lowest profile. */
internal class BestOrder(private val graph: NodeGraph, private val checkpoint: Checkpoint = Checkpoint.unheard()) {
    private val nodeCount = graph.nodeCount
    private val numbers = IntArray(nodeCount)

    /** Node by number. */
    var order: IntArray = IntArray(0)
        private set
    var halfBandwidth: Int = Int.MAX_VALUE
        private set

    /** Sum over the rows of i - min(j) + 1. */
    var profile: Long = Long.MAX_VALUE
        private set

    /** Entries read so far, as [CuthillMcKee.work]. */
    var work: Long = 0
        private set

    /**
     * Keeps [candidate], the nodes in the order of its first places, or its reverse, whichever has the smaller profile, if that is better; copied.
     *
     * @return the half-bandwidth of the candidate.
     */
    fun offer(candidate: IntArray): Int {
        for (i in 0 until nodeCount) numbers[candidate[i]] = i
        checkpoint.ask()
        var widest = 0
        var forward = nodeCount.toLong()
        var backward = nodeCount.toLong()
        for (node in 0 until nodeCount) {
            checkpoint.pass()
            val i = numbers[node]
            var low = i
            var high = i
            for (k in graph.starts[node] until graph.starts[node + 1]) {
                val n = numbers[graph.targets[k]]
                if (n < low) low = n
                if (n > high) high = n
            }
            if (high - i > widest) widest = high - i
            forward += i - low
            backward += high - i
        }
        work += graph.targets.size
        val lower = minOf(forward, backward)
        if (widest > halfBandwidth || widest == halfBandwidth && lower >= profile) return widest
        halfBandwidth = widest
        profile = lower
        order = candidate.copyOf(nodeCount)
        if (backward < forward) order.reverse()
        return widest
    }
}
