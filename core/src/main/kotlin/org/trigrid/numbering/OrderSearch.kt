package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * Searches for an order of low bandwidth of a connected graph, cheapest means first, within a budget of work.
 *
 * The budget counts graph entries read, never time, so that the same mesh gets the same numbers everywhere.
 *
 * 1. Cuthill-McKee from the two ends of a long path, and the merged levels between them.
 * 2. Cuthill-McKee from whole stretches of the boundary, the best stretch then moved and resized: most domains are
 *    best swept from one of their sides. A sweep ends as soon as it is worse than the best.
 * 3. Merged levels from the best stretches and from places all round the boundary.
 * 4. Swaps of single nodes.
 *
 * A large graph is first searched in a small likeness of it, and then swept from the best places found there.
 *
 * @param boundary the nodes on the boundary, walk by walk; may be empty.
 */
internal class OrderSearch(
    private val graph: NodeGraph,
    private val boundary: IntArray,
    private val budget: Long,
    private val checkpoint: Checkpoint = Checkpoint.unheard(),
) {
    private val sweep = CuthillMcKee(graph, checkpoint)
    private val merged = GibbsPooleStockmeyer(graph, checkpoint)
    private val best = BestOrder(graph, checkpoint)
    private var otherWork = 0L

    /** Starts that gave an order, with its half-bandwidth. */
    private val tried = ArrayList<Tried>()
    private var bestStretch: SweepStart? = null
    private var sweepLimit = Int.MAX_VALUE

    val work: Long get() = sweep.work + merged.work + best.work + otherWork

    val halfBandwidth: Int get() = best.halfBandwidth

    /** The best order found. */
    fun search(): IntArray {
        if (graph.nodeCount > LARGE && boundary.isNotEmpty()) {
            fromLikeness()
        } else {
            fromEnds()
            if (boundary.isNotEmpty()) scanStretches()
        }
        // A likeness may have no start that works in the graph itself.
        if (best.order.isEmpty()) fromEnds()
        refineStretch()
        mergeFromStretches()
        if (graph.nodeCount <= LARGE) mergeFromPlaces()
        climb()
        return best.order
    }

    private fun fromLikeness() {
        val coarse = CoarseGraph.of(graph, boundary, COARSE, checkpoint)
        otherWork += 3L * graph.targets.size
        val search = OrderSearch(coarse.graph, coarse.boundary, COARSE_BUDGET, checkpoint)
        search.search()
        for (start in search.bestStarts(LARGE_STARTS)) {
            if (best.halfBandwidth < Int.MAX_VALUE && !within(MERGED)) return
            run(coarse.inLargeGraph(start))
        }
    }

    /** The best starts, of each way no more than two. */
    private fun bestStarts(count: Int): List<SweepStart> {
        val sorted = tried.sortedBy { it.halfBandwidth }
        return SweepStart.Way.entries.flatMap { way -> sorted.filter { it.start.way == way }.take(2) }
            .sortedBy { it.halfBandwidth }.take(count).map { it.start }
    }

    private fun fromEnds() {
        val search = PseudoPeripheral(graph, checkpoint)
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

    /** Half-bandwidth of the merged levels, or -1 if that cannot be lower than the best. */
    private fun merge(first: IntArray, second: IntArray): Int =
        if (merged.run(first, second, best.halfBandwidth)) best.offer(merged.order) else -1

    private fun within(share: Double): Boolean = work < share * budget

    /** Stretches all round the boundary, of one node and of several parts of its length. */
    private fun scanStretches() {
        val m = boundary.size
        for (parts in STRETCH_PARTS) {
            val count = maxOf(1, m / parts)
            for (p in 0 until POSITIONS) {
                if (!within(SCANNED)) return
                trySweep(((2 * p + 1L) * m / (2 * POSITIONS)).toInt(), count)
            }
        }
    }

    /** Moves and resizes the best stretch by steps that are halved when none helps. */
    private fun refineStretch() {
        var step = maxOf(1, boundary.size / (2 * POSITIONS))
        if (graph.nodeCount > LARGE) step = maxOf(1, step / 4)
        while (within(REFINED)) {
            val now = bestStretch ?: return
            val better = MOVES.any {
                trySweep(Math.floorMod(now.from + it[0] * step, boundary.size), now.count + it[1] * step)
            }
            if (better) continue
            if (step == 1) return
            step /= 2
        }
    }

    /** Sweeps from a stretch of the boundary and keeps it if the half-bandwidth is lower than of those before. */
    private fun trySweep(from: Int, count: Int): Boolean {
        if (count < 1 || count > boundary.size) return false
        val b = sweep.run(boundary, from, count, sweepLimit - 1)
        if (b < 0) return false
        sweepLimit = b
        val start = SweepStart(from, count, SweepStart.Way.SWEEP)
        bestStretch = start
        tried.add(Tried(start, b))
        if (b <= best.halfBandwidth) best.offer(sweep.order)
        return true
    }

    private fun run(start: SweepStart) {
        if (start.way == SweepStart.Way.SWEEP) trySweep(start.from, start.count) else mergeFrom(start)
    }

    /** The last stretches that lowered the half-bandwidth, the best first. */
    private fun mergeFromStretches() {
        val stretches = tried.filter { it.start.way == SweepStart.Way.SWEEP }.reversed().take(MERGED_STRETCHES)
        for (t in stretches) {
            if (!within(MERGED)) return
            mergeBothWays(t.start.from, t.start.count)
        }
    }

    private fun mergeFromPlaces() {
        for (p in 0 until MERGE_POSITIONS) {
            val from = (p.toLong() * boundary.size / MERGE_POSITIONS).toInt()
            for (count in intArrayOf(1, boundary.size / 8)) {
                if (!within(MERGED) || count < 1) return
                mergeFrom(SweepStart(from, count, SweepStart.Way.MERGED))
            }
        }
    }

    private fun mergeBothWays(from: Int, count: Int) {
        mergeFrom(SweepStart(from, count, SweepStart.Way.MERGED))
        mergeFrom(SweepStart(from, count, SweepStart.Way.MERGED_BACK))
    }

    /** The merged levels between a stretch and the nodes farthest from it, or the last of them for a single node. */
    private fun mergeFrom(start: SweepStart) {
        val first = IntArray(start.count) { boundary[(start.from + it) % boundary.size] }
        if (!merged.runToFarEnd(first, start.way == SweepStart.Way.MERGED_BACK, best.halfBandwidth)) return
        tried.add(Tried(start, best.offer(merged.order)))
    }

    private fun climb() {
        if (!within(MERGED)) return
        val climbing = HillClimbing(graph, best.order, checkpoint)
        climbing.climb(budget - work)
        otherWork += climbing.work
        best.offer(climbing.order)
    }

    private class Tried(val start: SweepStart, val halfBandwidth: Int)

    private companion object {
        /** Shares of the budget after which a means is given up. */
        const val EARLY = 0.5
        const val SCANNED = 0.35
        const val REFINED = 0.45
        const val MERGED = 0.9

        const val POSITIONS = 16
        const val MERGE_POSITIONS = 16
        const val MERGED_STRETCHES = 4
        val STRETCH_PARTS = intArrayOf(4, Int.MAX_VALUE, 8, 3, 16, 2)

        /** Above this many nodes a likeness of at most [COARSE] nodes is searched first. */
        const val LARGE = 15_000
        const val COARSE = 6_000
        const val COARSE_BUDGET = 2_500_000L
        const val LARGE_STARTS = 3

        /** Changes of start and length, in steps. */
        val MOVES = arrayOf(
            intArrayOf(1, 0), intArrayOf(-1, 0), intArrayOf(0, 1), intArrayOf(0, -1),
            intArrayOf(1, -1), intArrayOf(-1, 1), intArrayOf(1, -2), intArrayOf(-1, 2),
        )
    }
}
