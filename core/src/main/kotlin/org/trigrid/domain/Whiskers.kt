package org.trigrid.domain

import org.trigrid.diagnostics.FaultKind

/**
 * Pairs of boundary segments u→v and v→u: where such a line ends in a node of no other use it is a spike,
 * reported once at that tip; elsewhere it is an overlap.
 */
internal class Whiskers(
    private val checked: CheckedDomain,
    /** 2 per pair: tested segments. Not modified. */
    private val pairs: IntArray,
    private val faults: FaultList,
) {
    private val pairsAt = NodeSegments.leaving(checked.domain.nodeCount, IntArray(pairs.size) { checked.start(pairs[it]) })
    private val otherPairsAt = NodeSegments.arriving(checked.domain.nodeCount, IntArray(pairs.size) { checked.start(pairs[it]) })
    private val isDone = BooleanArray(pairs.size / 2)

    fun find() {
        for (pair in isDone.indices) {
            if (isAlone(pair)) isDone[pair] = true
            for (side in 0..1) stripFrom(checked.start(pairs[2 * pair + side]))
        }
        for (pair in isDone.indices) if (!isDone[pair]) overlap(pair)
    }

    /** A loop of two nodes; it is reported as a loop. */
    private fun isAlone(pair: Int): Boolean {
        val s = pairs[2 * pair]
        return checked.leaving.countAt(checked.start(s)) == 1 && checked.leaving.countAt(checked.end(s)) == 1 &&
            checked.arriving.countAt(checked.start(s)) == 1 && checked.arriving.countAt(checked.end(s)) == 1
    }

    /** Takes the pairs off one by one from [tip] on, as long as nothing else joins. */
    private fun stripFrom(tip: Int) {
        var node = tip
        while (true) {
            val pair = onlyPairAt(node)
            if (pair < 0) return
            isDone[pair] = true
            if (node == tip) spike(tip)
            val first = pairs[2 * pair]
            node = if (checked.start(first) == node) checked.end(first) else checked.start(first)
        }
    }

    /** The one pair left at a node where every boundary segment belongs to a pair, or -1. */
    private fun onlyPairAt(node: Int): Int {
        val pairCount = pairsAt.countAt(node) + otherPairsAt.countAt(node)
        if (checked.leaving.countAt(node) != pairCount || checked.arriving.countAt(node) != pairCount) return -1
        var found = -1
        var open = 0
        val look = { pair: Int ->
            if (!isDone[pair]) {
                found = pair
                open++
            }
        }
        pairsAt.forEachAt(node, look)
        otherPairsAt.forEachAt(node, look)
        return if (open == 1) found else -1
    }

    private fun spike(tip: Int) =
        faults.add(FaultKind.SPIKE, checked.xy[2 * tip], checked.xy[2 * tip + 1], intArrayOf(tip)) {
            "the boundary runs to node ${checked.nodeText(tip)} and straight back"
        }

    private fun overlap(pair: Int) {
        val s = pairs[2 * pair]
        val t = pairs[2 * pair + 1]
        val nodes = intArrayOf(checked.nodeAtStart(s), checked.nodeAtEnd(s), checked.nodeAtStart(t), checked.nodeAtEnd(t))
        faults.add(FaultKind.OVERLAP, checked.xy[2 * nodes[0]], checked.xy[2 * nodes[0] + 1], nodes) {
            "segments ${checked.segmentText(s)} and ${checked.segmentText(t)} run along each other"
        }
    }
}
