package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * The paper's renumbering (section 4): Cuthill-McKee from each boundary node of lowest degree, the one with the lowest
 * bandwidth kept, the first of several.
 *
 * Departure: a start is given up as soon as its bandwidth is above the best, and no more starts are tried once the work
 * is that of [PASSES] whole sweeps (of more in a small mesh), which only meshes with many hundred such nodes reach.
 */
internal object PaperNumbering {
    private const val PASSES = 40L
    private const val SMALL_BUDGET = 40_000_000L

    /** @param boundary may be empty; then all nodes count as boundary. */
    fun order(graph: NodeGraph, boundary: IntArray, checkpoint: Checkpoint = Checkpoint.unheard()): IntArray {
        val nodes = if (boundary.isEmpty()) IntArray(graph.nodeCount) { it } else boundary
        val lowest = nodes.minOf { graph.degree(it) }
        val budget = maxOf(SMALL_BUDGET, PASSES * graph.targets.size)
        val sweep = CuthillMcKee(graph, checkpoint)
        val root = IntArray(1)
        var limit = Int.MAX_VALUE
        var best = IntArray(0)
        for (node in nodes) {
            if (graph.degree(node) != lowest) continue
            root[0] = node
            val b = sweep.run(root, 0, 1, limit)
            if (b >= 0) {
                limit = b - 1
                best = sweep.order.copyOf(graph.nodeCount)
            }
            if (limit < 0 || sweep.work > budget) break
        }
        return best
    }
}
