package org.trigrid.domain

import org.trigrid.diagnostics.FaultKind

/** All faults between embedded lines with small whole coordinates, by integers and all pairs: the reference for the tests. */
internal class SoupFaults(lines: List<IntArray>) {
    private val lines = lines.map { IntLine(it[0], it[1], it[2], it[3]) }

    private class IntLine(val ax: Int, val ay: Int, val bx: Int, val by: Int) {
        val ends get() = listOf(ax to ay, bx to by)

        fun side(p: Pair<Int, Int>) = Integer.signum((bx - ax) * (p.second - ay) - (by - ay) * (p.first - ax))

        fun along(p: Pair<Int, Int>) = (bx - ax) * (p.first - ax) + (by - ay) * (p.second - ay)

        val square get() = along(bx to by)

        fun hasInside(p: Pair<Int, Int>) = side(p) == 0 && along(p) > 0 && along(p) < square

        fun crosses(o: IntLine) = side(o.ends[0]) * side(o.ends[1]) < 0 && o.side(ends[0]) * o.side(ends[1]) < 0

        fun overlaps(o: IntLine): Boolean {
            if (side(o.ends[0]) != 0 || side(o.ends[1]) != 0) return false
            val from = minOf(along(o.ends[0]), along(o.ends[1]))
            val to = maxOf(along(o.ends[0]), along(o.ends[1]))
            return maxOf(0, from) < minOf(square, to)
        }
    }

    /** Kinds that do not occur are left out. */
    fun counts(): Map<FaultKind, Int> {
        val pairs = lines.indices.flatMap { i -> (i + 1 until lines.size).map { lines[i] to lines[it] } }
        val touches = HashSet<Pair<Pair<Int, Int>, Int>>()
        for ((t, line) in lines.withIndex()) {
            for (other in lines) for (p in other.ends) if (line.hasInside(p)) touches.add(p to t)
        }
        touches.removeAll { (p, t) -> lines.any { p in it.ends && it !== lines[t] && it.overlaps(lines[t]) } }
        val counts = mapOf(
            FaultKind.CROSSING to pairs.count { (s, t) -> s.crosses(t) },
            FaultKind.OVERLAP to pairs.count { (s, t) -> s.overlaps(t) },
            FaultKind.TOUCHING to touches.size,
        )
        return counts.filterValues { it > 0 }
    }
}
