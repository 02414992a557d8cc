package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * A small likeness of a large graph, made of groups of nodes that are near each other: where a sweep of the large graph
 * should start can be found out on it at little cost.
 */
internal class CoarseGraph private constructor(
    val graph: NodeGraph,
    /** The groups along the boundary. */
    val boundary: IntArray,
    /** Per entry of [boundary], the place in the large graph's boundary where the group begins; then its size. */
    private val places: IntArray,
) {
    /** The same stretch of the boundary in the large graph. */
    fun inLargeGraph(start: SweepStart): SweepStart {
        val m = boundary.size
        val from = places[start.from]
        val end = start.from + start.count
        val to = if (end < m) places[end] else places[m] + places[end - m]
        return SweepStart(from, if (start.count == 1) 1 else to - from, start.way)
    }

    companion object {
        /** Groups until there are no more than [most] nodes left, or grouping no longer helps. */
        fun of(graph: NodeGraph, boundary: IntArray, most: Int, checkpoint: Checkpoint = Checkpoint.unheard()): CoarseGraph {
            var current = graph
            val groups = IntArray(graph.nodeCount) { it }
            while (current.nodeCount > most) {
                val next = IntArray(current.nodeCount)
                val count = group(current, next, checkpoint)
                if (count > current.nodeCount / 2) break
                for (node in groups.indices) {
                    checkpoint.pass()
                    groups[node] = next[groups[node]]
                }
                current = current.quotient(next, count, checkpoint)
            }
            val along = ArrayList<Int>()
            val places = ArrayList<Int>()
            for (i in boundary.indices) {
                checkpoint.pass()
                val g = groups[boundary[i]]
                if (along.isNotEmpty() && along.last() == g) continue
                along.add(g)
                places.add(i)
            }
            places.add(boundary.size)
            return CoarseGraph(current, along.toIntArray(), places.toIntArray())
        }

        /** A node whose neighbours are all free makes a group with them; what is left over joins a neighbour's group. */
        private fun group(graph: NodeGraph, groups: IntArray, checkpoint: Checkpoint): Int {
            groups.fill(-1)
            var count = 0
            for (node in groups.indices) {
                checkpoint.pass()
                if (groups[node] >= 0 || !allFree(graph, groups, node)) continue
                groups[node] = count
                for (k in graph.starts[node] until graph.starts[node + 1]) groups[graph.targets[k]] = count
                count++
            }
            val whole = groups.copyOf()
            for (node in groups.indices) {
                checkpoint.pass()
                if (groups[node] >= 0) continue
                for (k in graph.starts[node] until graph.starts[node + 1]) {
                    if (whole[graph.targets[k]] >= 0) groups[node] = whole[graph.targets[k]]
                }
                if (groups[node] < 0) groups[node] = count++
            }
            return count
        }

        private fun allFree(graph: NodeGraph, groups: IntArray, node: Int): Boolean {
            for (k in graph.starts[node] until graph.starts[node + 1]) if (groups[graph.targets[k]] >= 0) return false
            return true
        }
    }
}
