package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/** A connected part of a graph, with node numbers of its own. */
internal class GraphPart(
    val graph: NodeGraph,
    /** Number in the whole graph of each node of the part. */
    val nodes: IntArray,
    /** Nodes on the boundary, in the part's numbers. */
    val boundary: IntArray,
)

/** Takes a graph apart. */
internal object GraphParts {
    /**
     * The connected parts, in the order of their lowest nodes. Each is numbered by a breadth-first sweep, so that
     * later sweeps find neighbours near each other in memory.
     */
    fun of(graph: NodeGraph, boundaryNodes: IntArray, checkpoint: Checkpoint = Checkpoint.unheard()): List<GraphPart> {
        val nodeCount = graph.nodeCount
        val local = IntArray(nodeCount) { -1 }
        val partOf = IntArray(nodeCount)
        val queue = IntArray(nodeCount)
        val bounds = ArrayList<Int>()
        var tail = 0
        for (seed in 0 until nodeCount) {
            if (local[seed] >= 0) continue
            val first = tail
            bounds.add(first)
            local[seed] = 0
            queue[tail++] = seed
            var head = first
            while (head < tail) {
                checkpoint.pass()
                val node = queue[head++]
                partOf[node] = bounds.size - 1
                for (k in graph.starts[node] until graph.starts[node + 1]) {
                    val next = graph.targets[k]
                    if (local[next] >= 0) continue
                    local[next] = tail - first
                    queue[tail++] = next
                }
            }
        }
        bounds.add(tail)
        checkpoint.ask()
        val boundaries = boundariesByPart(boundaryNodes, partOf, local, bounds.size - 1)
        return List(bounds.size - 1) { part ->
            checkpoint.pass()
            val nodes = queue.copyOfRange(bounds[part], bounds[part + 1])
            GraphPart(graph.relabelled(nodes, local, checkpoint), nodes, boundaries[part])
        }
    }

    private fun boundariesByPart(boundaryNodes: IntArray, partOf: IntArray, local: IntArray, parts: Int): Array<IntArray> {
        val counts = IntArray(parts)
        for (node in boundaryNodes) counts[partOf[node]]++
        val result = Array(parts) { IntArray(counts[it]) }
        counts.fill(0)
        for (node in boundaryNodes) result[partOf[node]][counts[partOf[node]]++] = local[node]
        return result
    }
}
