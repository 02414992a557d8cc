package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * Numbers a connected graph level by level from a set of roots (Cuthill and McKee 1969, Proc. 24th Nat. Conf. ACM,
 * 157-172): the neighbours of the node numbered first, in order of their degree, then those of the second, and so on.
 *
 * One object serves many sweeps over the same graph without allocating.
 */
internal class CuthillMcKee(private val graph: NodeGraph, private val checkpoint: Checkpoint = Checkpoint.unheard()) {
    /** The nodes in the order of the last whole sweep, and one place more: [grow] writes before it knows whether it should. */
    val order: IntArray = IntArray(graph.nodeCount + 1)

    /** Entries of [NodeGraph.targets] read so far: the measure of work. */
    var work: Long = 0
        private set

    /** Where the last level of the last whole sweep starts in [order]. */
    var lastLevel: Int = 0
        private set

    /** Levels of the last whole sweep, the roots' not counted. */
    var depth: Int = 0
        private set

    private val seenIn = IntArray(graph.nodeCount)
    private var sweep = 0

    /** Where a root is in [order]; of other nodes anything. */
    private val rootPlace = IntArray(graph.nodeCount)

    /**
     * Sweeps from the nodes `roots[from], roots[from + 1], …`, [count] of them, read round the end of the array.
     *
     * @param limit the sweep ends as soon as its half-bandwidth is above this.
     * @return the half-bandwidth of the order, or -1 if it is above the limit.
     */
    fun run(roots: IntArray, from: Int, count: Int, limit: Int): Int {
        sweep++
        var tail = 0
        for (i in 0 until count) {
            val root = roots[(from + i) % roots.size]
            if (seenIn[root] == sweep) continue
            seenIn[root] = sweep
            order[tail++] = root
        }
        return grow(tail, limit)
    }

    private fun grow(rootCount: Int, limit: Int): Int {
        val starts = graph.starts
        val targets = graph.targets
        var tail = rootCount
        var levelEnd = rootCount
        // The roots among themselves: they are few, and neighbours of the first is at most this far.
        var widest = rootSpan(rootCount)
        lastLevel = 0
        depth = 0
        var head = 0
        while (head < tail) {
            if (head == levelEnd) {
                checkpoint.pass(tail - levelEnd)
                lastLevel = levelEnd
                levelEnd = tail
                depth++
            }
            val node = order[head]
            val before = tail
            for (k in starts[node] until starts[node + 1]) {
                // Whether a neighbour is new could not be foreseen by a branch: 1 or 0.
                val next = targets[k]
                val difference = seenIn[next] xor sweep
                seenIn[next] = sweep
                order[tail] = next
                tail += (difference or -difference) ushr 31
            }
            if (tail > before && tail - 1 - head > widest) {
                widest = tail - 1 - head
                if (widest > limit) {
                    work += 6L * head + 6
                    return -1
                }
            }
            head++
        }
        work += targets.size
        return if (widest > limit) -1 else widest
    }

    /** Largest difference of places of two neighbouring roots. */
    private fun rootSpan(rootCount: Int): Int {
        if (rootCount < 2) return 0
        for (i in 0 until rootCount) rootPlace[order[i]] = i
        var widest = 0
        for (i in 0 until rootCount) {
            val node = order[i]
            for (k in graph.starts[node] until graph.starts[node + 1]) {
                val target = graph.targets[k]
                val j = rootPlace[target]
                if (j < rootCount && order[j] == target) widest = maxOf(widest, j - i)
            }
        }
        return widest
    }
}
