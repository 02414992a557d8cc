package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/** Finds the two ends of a long shortest path through a connected graph (George and Liu 1979, ACM TOMS 5:284-295). */
internal class PseudoPeripheral(private val graph: NodeGraph, private val checkpoint: Checkpoint = Checkpoint.unheard()) {
    private val sweep = CuthillMcKee(graph, checkpoint)

    val work: Long get() = sweep.work

    /** Two nodes as far apart as the search could find; the same node twice in a graph of one node. */
    fun ends(): IntArray {
        var end = NodeGraph.nodesByDegree(graph.starts, checkpoint)[0]
        var depth = -1
        val root = IntArray(1)
        for (round in 0 until ROUNDS) {
            root[0] = end
            sweep.run(root, 0, 1, Int.MAX_VALUE)
            if (sweep.depth <= depth) break
            depth = sweep.depth
            end = lowestDegree(sweep.order, sweep.lastLevel)
        }
        return intArrayOf(root[0], end)
    }

    private fun lowestDegree(order: IntArray, from: Int): Int {
        var best = order[from]
        for (i in from + 1 until graph.nodeCount) if (graph.degree(order[i]) < graph.degree(best)) best = order[i]
        return best
    }

    private companion object {
        /** Two or three rounds are the rule. */
        const val ROUNDS = 8
    }
}
