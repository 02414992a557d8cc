package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * Numbers a connected graph along the merged levels seen from its two ends (Gibbs, Poole and Stockmeyer 1976, SIAM J.
 * Numer. Anal. 13:236-250).
 *
 * Departure: an end may be a set of nodes, such as one side of the domain, instead of a single node.
 */
internal class GibbsPooleStockmeyer(private val graph: NodeGraph, private val checkpoint: Checkpoint = Checkpoint.unheard()) {
    private val nodeCount = graph.nodeCount
    private val fromFirst = IntArray(nodeCount)
    private val fromSecond = IntArray(nodeCount)
    private val queue = IntArray(nodeCount + 1)

    /** Where the nodes farthest from the roots start in [queue]. */
    private var lastLevel = 0

    /** The merged level of each node, -1 while it is open, [NUMBERED] at the end. */
    private val level = IntArray(nodeCount)
    private var widths = IntArray(0)

    /** Entries read so far, as [CuthillMcKee.work]. */
    var work: Long = 0
        private set

    /** The nodes in the order found, and one place more; valid after [run]. */
    val order: IntArray = IntArray(nodeCount + 1)

    /**
     * Finds an order from the two end sets; the levels run from the first to the second.
     *
     * @param limit no order is made when a level is wider than this, or as soon as two neighbours would be farther apart.
     * @return whether an order was made.
     */
    fun run(first: IntArray, second: IntArray, limit: Int): Boolean {
        val depth = distances(first, fromFirst)
        if (isTooShallow(depth, limit)) return false
        distances(second, fromSecond)
        return merge(depth, limit) && number(depth, limit)
    }

    /**
     * As the other, with the nodes farthest from [start] as the other end, or only the last of them if it is a single node.
     *
     * @param back the levels run from the far end to [start].
     */
    fun runToFarEnd(start: IntArray, back: Boolean, limit: Int): Boolean {
        val depth = distances(start, if (back) fromSecond else fromFirst)
        if (!back && isTooShallow(depth, limit)) return false
        val far = queue.copyOfRange(if (start.size == 1) nodeCount - 1 else lastLevel, nodeCount)
        if (!back) {
            distances(far, fromSecond)
            return merge(depth, limit) && number(depth, limit)
        }
        // The far end may be farther from some node than the start is from it.
        val depthBack = distances(far, fromFirst)
        if (isTooShallow(depthBack, limit)) return false
        return merge(depthBack, limit) && number(depthBack, limit)
    }

    /** Whether some level must be wider than [limit], as there are so few. */
    private fun isTooShallow(depth: Int, limit: Int): Boolean = nodeCount > (depth + 1L) * limit

    private fun distances(roots: IntArray, distance: IntArray): Int {
        distance.fill(-1)
        var tail = 0
        for (root in roots) {
            if (distance[root] == 0) continue
            distance[root] = 0
            queue[tail++] = root
        }
        var head = 0
        while (head < tail) {
            checkpoint.pass()
            val node = queue[head++]
            val farther = distance[node] + 2
            for (k in graph.starts[node] until graph.starts[node + 1]) {
                // Whether a neighbour is new, and its distance -1, could not be foreseen by a branch: 1 or 0.
                val next = graph.targets[k]
                val isNew = distance[next] ushr 31
                distance[next] += farther * isNew
                queue[tail] = next
                tail += isNew
            }
        }
        work += graph.targets.size
        val depth = distance[queue[nodeCount - 1]]
        lastLevel = nodeCount - 1
        while (lastLevel > 0 && distance[queue[lastLevel - 1]] == depth) lastLevel--
        return depth
    }

    /** Nodes on which both ends agree are settled; the others follow, part by part, the end that keeps levels narrow. */
    private fun merge(depth: Int, limit: Int): Boolean {
        widths = IntArray(depth + 1)
        for (node in 0 until nodeCount) {
            checkpoint.pass()
            fromSecond[node] = (depth - fromSecond[node]).coerceIn(0, depth)
            level[node] = if (fromFirst[node] == fromSecond[node]) fromFirst[node].also { widths[it]++ } else -1
        }
        if (widths.max() > limit) return false
        val parts = openParts()
        val byFirst = IntArray(depth + 1)
        val bySecond = IntArray(depth + 1)
        for (part in parts.sortedByDescending { it.size }) {
            for (node in part) {
                checkpoint.pass()
                byFirst[fromFirst[node]]++
                bySecond[fromSecond[node]]++
            }
            var widestFirst = 0
            var widestSecond = 0
            for (node in part) {
                checkpoint.pass()
                widestFirst = maxOf(widestFirst, widths[fromFirst[node]] + byFirst[fromFirst[node]])
                widestSecond = maxOf(widestSecond, widths[fromSecond[node]] + bySecond[fromSecond[node]])
            }
            if (minOf(widestFirst, widestSecond) > limit) return false
            val chosen = if (widestSecond < widestFirst) fromSecond else fromFirst
            for (node in part) {
                checkpoint.pass()
                byFirst[fromFirst[node]] = 0
                bySecond[fromSecond[node]] = 0
                level[node] = chosen[node]
                widths[chosen[node]]++
            }
        }
        return true
    }

    private fun openParts(): List<IntArray> {
        val parts = ArrayList<IntArray>()
        for (seed in 0 until nodeCount) {
            if (level[seed] != -1) continue
            var tail = 0
            queue[tail++] = seed
            level[seed] = OPEN_AND_FOUND
            var head = 0
            while (head < tail) {
                checkpoint.pass()
                val node = queue[head++]
                for (k in graph.starts[node] until graph.starts[node + 1]) {
                    val next = graph.targets[k]
                    if (level[next] != -1) continue
                    level[next] = OPEN_AND_FOUND
                    queue[tail++] = next
                }
            }
            work += DEGREE.toLong() * tail
            parts.add(queue.copyOf(tail))
        }
        return parts
    }

    /** @return whether it could be done within [limit]. */
    private fun number(depth: Int, limit: Int): Boolean {
        val nodes = nodesByLevel(depth)
        var tail = 0
        var previous = 0
        var at = 0
        for (l in 0..depth) {
            val levelStart = tail
            val levelEnd = at + widths[l]
            for (i in previous until levelStart) {
                val before = tail
                tail = take(order[i], l, tail)
                if (tail > before && tail - 1 - i > limit) return false.also { work += 2L * DEGREE * tail }
            }
            var head = levelStart
            while (tail < levelEnd) {
                while (head < tail) tail = take(order[head++], l, tail)
                if (tail == levelEnd) break
                // Nothing in this level is next to what is numbered: its next node by degree starts again.
                while (level[nodes[at]] == NUMBERED) at++
                level[nodes[at]] = NUMBERED
                order[tail++] = nodes[at]
            }
            previous = levelStart
            at = levelEnd
        }
        work += 2L * graph.targets.size
        return true
    }

    private fun take(node: Int, l: Int, tail: Int): Int {
        checkpoint.pass()
        var end = tail
        for (k in graph.starts[node] until graph.starts[node + 1]) {
            val next = graph.targets[k]
            // 1 for a node of this level without a number, else 0.
            val isWanted = (level[next] xor l) - 1 ushr 31
            level[next] = level[next] or -isWanted and NUMBERED
            order[end] = next
            end += isWanted
        }
        return end
    }

    /** Nodes sorted by level, then by degree. */
    private fun nodesByLevel(depth: Int): IntArray {
        val place = IntArray(depth + 2)
        for (l in 0..depth) place[l + 1] = place[l] + widths[l]
        val nodes = IntArray(nodeCount)
        for (node in NodeGraph.nodesByDegree(graph.starts, checkpoint)) {
            checkpoint.pass()
            nodes[place[level[node]]++] = node
        }
        return nodes
    }

    private companion object {
        const val OPEN_AND_FOUND = -2

        /** No level, as there are not so many, and with all bits that a level can have. */
        const val NUMBERED = Int.MAX_VALUE

        /** Neighbours that a node has about. */
        const val DEGREE = 6
    }
}
