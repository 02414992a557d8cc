package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint

/**
 * The nodes of a domain as a ray that turns about its centre meets them, told by their distances from the centre and the
 * angles from each to the next. Where the ray begins, and which way it turns, is so chosen that this list is the least of all; so
 * the first node turns and mirrors with the domain; where several nodes may be the first, the list is the same for all.
 *
 * Symmetric figures are found in this way by M. J. Atallah (1985), "On symmetry detection", IEEE Trans. Comput. C-34:663-666.
 */
internal class PolarOrder(
    domain: Domain,
    centreX: Double,
    centreY: Double,
    /** Of the domain: the unit of the distances. */
    radius: Double,
    private val checkpoint: Checkpoint,
) {
    private val distances = LongArray(domain.nodeCount)
    private val angles = DoubleArray(domain.nodeCount)

    /** Nodes by their angles; those of one angle by their distances. Without those in the centre. */
    private val order: IntArray

    init {
        val counted = ArrayList<Int>(domain.nodeCount)
        for (node in 0 until domain.nodeCount) {
            checkpoint.pass()
            val x = domain.x(node) - centreX
            val y = domain.y(node) - centreY
            distances[node] = whole(Math.sqrt(x * x + y * y) / radius)
            angles[node] = StrictMath.atan2(y, x)
            if (distances[node] > 0) counted.add(node)
        }
        order = ordered(counted.sortedBy { angles[it] }.toIntArray())
    }

    /** The angle at which the first node lies. */
    fun direction(): Double {
        if (order.isEmpty()) return 0.0
        val forth = list(order)
        val back = order.reversedArray()
        // Nodes of one angle come by their distances in both lists.
        sortRuns(back)
        val mirrored = list(back)
        val first = leastRotation(forth)
        val firstBack = leastRotation(mirrored)
        return if (compare(forth, first, mirrored, firstBack) <= 0) angles[order[first]] else angles[back[firstBack]]
    }

    /** [byAngle] begun where an angle ends, and each run of one angle by distances. */
    private fun ordered(byAngle: IntArray): IntArray {
        val n = byAngle.size
        val end = byAngle.indices.firstOrNull { gap(byAngle[it], byAngle[(it + 1) % n]) != 0L } ?: return byAngle
        val result = IntArray(n) { byAngle[(end + 1 + it) % n] }
        sortRuns(result)
        return result
    }

    private fun sortRuns(nodes: IntArray) {
        var from = 0
        while (from < nodes.size) {
            checkpoint.pass()
            var to = from + 1
            while (to < nodes.size && gap(nodes[to - 1], nodes[to]) == 0L) to++
            if (to - from > 1) {
                nodes.copyOfRange(from, to).sortedBy { distances[it] }.forEachIndexed { i, node -> nodes[from + i] = node }
            }
            from = to
        }
    }

    /** From one node to the next, as a whole number. */
    private fun gap(from: Int, to: Int): Long {
        val turn = Math.abs(angles[to] - angles[from])
        return whole(Math.min(turn, 2 * Math.PI - turn))
    }

    /** Per node two numbers: its distance, and the angle to the next one. */
    private fun list(nodes: IntArray): LongArray = LongArray(2 * nodes.size) {
        val node = nodes[it / 2]
        if (it % 2 == 0) distances[node] else gap(node, nodes[(it / 2 + 1) % nodes.size])
    }

    /**
     * Where the least rotation of a list begins, in time linear in its length.
     *
     * Source: K. S. Booth (1980), "Lexicographically least circular substrings", Inf. Process. Lett. 10:240-242, in the form with two
     * candidates.
     */
    private fun leastRotation(list: LongArray): Int {
        val n = list.size / 2
        var a = 0
        var b = 1
        var same = 0
        while (a < n && b < n && same < n) {
            checkpoint.pass()
            val sign = compareAt(list, (a + same) % n, list, (b + same) % n)
            when {
                sign == 0 -> same++
                sign > 0 -> a += same + 1
                else -> b += same + 1
            }
            if (sign == 0) continue
            if (a == b) b++
            same = 0
        }
        return Math.min(a, b)
    }

    private fun compare(list: LongArray, first: Int, other: LongArray, otherFirst: Int): Int {
        val n = list.size / 2
        for (i in 0 until n) {
            val sign = compareAt(list, (first + i) % n, other, (otherFirst + i) % n)
            if (sign != 0) return sign
        }
        return 0
    }

    private fun compareAt(list: LongArray, i: Int, other: LongArray, j: Int): Int {
        val sign = list[2 * i].compareTo(other[2 * j])
        return if (sign != 0) sign else list[2 * i + 1].compareTo(other[2 * j + 1])
    }

    private fun whole(value: Double): Long = Math.round(value * UNITS)

    private companion object {
        /** Coarse against rounding errors. Of such a kind that common values do not lie halfway between two whole numbers. */
        const val UNITS = 9_173_501.37
    }
}
