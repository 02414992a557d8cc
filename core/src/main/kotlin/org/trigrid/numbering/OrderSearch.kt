package org.trigrid.numbering

/**
 * Searches for an order of low bandwidth of a connected graph, cheapest means first, within a budget of work.
 *
 * The budget counts graph entries read, never time, so that the same mesh gets the same numbers everywhere.
 *
 * 1. Cuthill-McKee from the two ends of a long path, and the merged levels between them.
 * 2. Cuthill-McKee from whole stretches of the boundary, the best stretch then moved and resized: most domains are
 *    best swept from one of their sides. A sweep ends as soon as it is worse than the best.
 * 3. Merged levels from the best stretches and from single boundary nodes.
 * 4. Swaps of single nodes.
 *
 * @param boundary the nodes on the boundary, walk by walk; may be empty.
 */
internal class OrderSearch(private val graph: NodeGraph, private val boundary: IntArray, private val budget: Long) {
    private val sweep = CuthillMcKee(graph)
    private val merged = GibbsPooleStockmeyer(graph)
    private val best = BestOrder(graph)
    private var otherWork = 0L

    /** Stretches of the boundary that lowered the half-bandwidth of the sweeps, the best last: start and length. */
    private val stretches = ArrayList<IntArray>()
    private var sweepLimit = Int.MAX_VALUE

    val work: Long get() = sweep.work + merged.work + best.work + otherWork

    val halfBandwidth: Int get() = best.halfBandwidth

    /** The best order found. */
    fun search(): IntArray {
        fromEnds()
        if (boundary.isNotEmpty()) {
            scanStretches()
            refineStretch()
            mergeFromStretches()
            mergeFromNodes()
        }
        climb()
        return best.order
    }

    private fun fromEnds() {
        val search = PseudoPeripheral(graph)
        val ends = search.ends()
        otherWork += search.work
        for (end in 0..1) {
            val b = sweep.run(ends, end, 1, sweepLimit)
            if (b < 0) continue
            sweepLimit = b
            best.offer(sweep.order)
        }
        merge(intArrayOf(ends[0]), intArrayOf(ends[1]))
        if (within(EARLY)) merge(intArrayOf(ends[1]), intArrayOf(ends[0]))
    }

    private fun merge(first: IntArray, second: IntArray) {
        if (merged.run(first, second, best.halfBandwidth)) best.offer(merged.order)
    }

    private fun within(share: Double): Boolean = work < share * budget

    /** Stretches all round the boundary, of one node and of several parts of its length. */
    private fun scanStretches() {
        val m = boundary.size
        for (parts in STRETCH_PARTS) {
            val count = maxOf(1, m / parts)
            for (p in 0 until POSITIONS) {
                if (!within(SCANNED)) return
                // Places that are not multiples of each other from one length to the next.
                trySweep((p.toLong() * m / POSITIONS).toInt(), count)
            }
        }
    }

    /** Moves and resizes the best stretch by steps that are halved when none helps. */
    private fun refineStretch() {
        val start = stretches.lastOrNull() ?: return
        var from = start[0]
        var count = start[1]
        var step = maxOf(1, boundary.size / (2 * POSITIONS))
        while (within(REFINED)) {
            val better = MOVES.any { trySweep(Math.floorMod(from + it[0] * step, boundary.size), count + it[1] * step) }
            if (better) {
                from = stretches.last()[0]
                count = stretches.last()[1]
            } else {
                if (step == 1) return
                step /= 2
            }
        }
    }

    /** Sweeps from a stretch of the boundary and keeps it if the half-bandwidth is lower than of those before. */
    private fun trySweep(from: Int, count: Int): Boolean {
        if (count < 1 || count > boundary.size) return false
        val b = sweep.run(boundary, from, count, sweepLimit - 1)
        if (b < 0) return false
        sweepLimit = b
        stretches.add(intArrayOf(from, count))
        if (b <= best.halfBandwidth) best.offer(sweep.order)
        return true
    }

    private fun mergeFromStretches() {
        for (stretch in stretches.asReversed()) {
            if (!within(MERGED)) return
            mergeBothWays(stretch[0], stretch[1])
        }
    }

    private fun mergeFromNodes() {
        for (p in 0 until MERGE_POSITIONS) {
            if (!within(MERGED)) return
            mergeBothWays((p.toLong() * boundary.size / MERGE_POSITIONS).toInt(), 1)
            mergeBothWays((p.toLong() * boundary.size / MERGE_POSITIONS).toInt(), maxOf(1, boundary.size / 8))
        }
    }

    /** The merged levels between a stretch and the nodes farthest from it, or the last of them for a single node. */
    private fun mergeBothWays(from: Int, count: Int) {
        val first = IntArray(count) { boundary[(from + it) % boundary.size] }
        sweep.run(first, 0, count, Int.MAX_VALUE)
        val order = sweep.order
        val last = order.copyOfRange(if (count == 1) order.size - 1 else sweep.lastLevel, order.size)
        merge(first, last)
        merge(last, first)
    }

    private fun climb() {
        if (!within(MERGED)) return
        val climbing = HillClimbing(graph, best.order)
        climbing.climb(budget - work)
        otherWork += climbing.work
        best.offer(climbing.order)
    }

    private companion object {
        /** Shares of the budget after which a means is given up. */
        const val EARLY = 0.5
        const val SCANNED = 0.45
        const val REFINED = 0.6
        const val MERGED = 0.9

        const val POSITIONS = 16
        const val MERGE_POSITIONS = 32
        val STRETCH_PARTS = intArrayOf(4, Int.MAX_VALUE, 8, 3, 16, 2)

        /** Changes of start and length, in steps. */
        val MOVES = arrayOf(
            intArrayOf(1, 0), intArrayOf(-1, 0), intArrayOf(0, 1), intArrayOf(0, -1),
            intArrayOf(1, -1), intArrayOf(-1, 1), intArrayOf(1, -2), intArrayOf(-1, 2),
        )
    }
}
