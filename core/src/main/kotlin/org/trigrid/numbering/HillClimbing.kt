package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint

/**
 * Lowers the half-bandwidth of an order by swapping the numbers of two nodes (Lim, Rodrigues and Xiao 2006, Eur. J.
 * Oper. Res. 174:69-91): a node at the end of a longest edge changes places with one nearer to the middle of its
 * neighbours, when neither then has an edge that long.
 */
internal class HillClimbing(
    private val graph: NodeGraph,
    order: IntArray,
    private val checkpoint: Checkpoint = Checkpoint.unheard(),
) {
    val order: IntArray = order.copyOf()
    private val numbers = IntArray(order.size).also { for (i in order.indices) it[order[i]] = i }

    var halfBandwidth: Int = 0
        private set

    /** Pairs tried and edges read, as [CuthillMcKee.work]. */
    var work: Long = 0
        private set

    init {
        for (node in order.indices) {
            checkpoint.pass()
            halfBandwidth = maxOf(halfBandwidth, reach(node, numbers[node], -1))
        }
        work += graph.targets.size
    }

    /** Climbs until stuck or until [work] is above [budget]; returns whether the half-bandwidth fell. */
    fun climb(budget: Long): Boolean {
        val before = halfBandwidth
        while (work < budget && lowerByOne(budget)) halfBandwidth = widest()
        return halfBandwidth < before
    }

    /** Tries to rid the order of all edges of length [halfBandwidth]. */
    private fun lowerByOne(budget: Long): Boolean {
        var again = true
        while (again && work < budget) {
            again = false
            var open = false
            for (i in order.indices) {
                checkpoint.pass()
                val node = order[i]
                if (reach(node, i, -1) < halfBandwidth) continue
                if (improve(node)) again = true else open = true
                if (work > budget) return false
            }
            work += graph.targets.size
            if (!open && !again) return true
            if (!open) again = true
        }
        return false
    }

    private fun improve(node: Int): Boolean {
        val i = numbers[node]
        var low = i
        var high = i
        for (k in graph.starts[node] until graph.starts[node + 1]) {
            val n = numbers[graph.targets[k]]
            low = minOf(low, n)
            high = maxOf(high, n)
        }
        val middle = (low + high) / 2
        val far = Math.abs(i - middle)
        for (d in 0 until far) {
            checkpoint.pass()
            if (trySwap(node, middle - d)) return true
            if (d > 0 && trySwap(node, middle + d)) return true
        }
        return false
    }

    private fun trySwap(node: Int, place: Int): Boolean {
        val i = numbers[node]
        if (place < 0 || place >= order.size || place == i) return false
        val other = order[place]
        work += 12
        if (reach(node, place, other) >= halfBandwidth || reach(other, i, node) >= halfBandwidth) return false
        order[i] = other
        order[place] = node
        numbers[node] = place
        numbers[other] = i
        return true
    }

    /** Longest edge of [node] if it had the number [at]; the edge to [except] keeps its length in a swap. */
    private fun reach(node: Int, at: Int, except: Int): Int {
        var widest = 0
        for (k in graph.starts[node] until graph.starts[node + 1]) {
            val next = graph.targets[k]
            val n = if (next == except) numbers[node] else numbers[next]
            val d = if (n > at) n - at else at - n
            if (d > widest) widest = d
        }
        return widest
    }

    private fun widest(): Int {
        var widest = 0
        for (i in order.indices) {
            checkpoint.pass()
            widest = maxOf(widest, reach(order[i], i, -1))
        }
        work += graph.targets.size
        return widest
    }
}
