package org.trigrid.domain

import org.trigrid.diagnostics.FaultKind

/** Embedded segments that do not lie in the domain. Decided exactly, at an end of each. */
internal class EmbeddedFaults(
    private val checked: CheckedDomain,
    private val windings: WindingFaults,
    /** Per tested segment. Not modified. */
    private val isFaulty: BooleanArray,
    private val faults: FaultList,
) {
    private val xy = checked.xy
    private val known = HashMap<Int, Boolean>()

    fun find() {
        for (t in checked.boundaryCount until checked.tested.size) {
            checked.checkpoint.pass()
            if (isFaulty[t] || isInside(t)) continue
            val a = checked.start(t)
            val nodes = intArrayOf(checked.nodeAtStart(t), checked.nodeAtEnd(t))
            faults.add(FaultKind.EMBEDDED_OUTSIDE, xy[2 * a], xy[2 * a + 1], nodes) {
                "embedded segment ${checked.segmentText(t)} at (${xy[2 * a]}, ${xy[2 * a + 1]}) lies outside of the domain"
            }
        }
    }

    private fun isInside(t: Int): Boolean {
        val a = checked.start(t)
        val b = checked.end(t)
        if (!checked.isOnBoundary(a)) return isPlaceInside(a)
        if (!checked.isOnBoundary(b)) return isPlaceInside(b)
        return !windings.isTrusted(a) || leavesInside(a, b)
    }

    private fun isPlaceInside(place: Int) = known.getOrPut(place) { windings.isInside(place) }

    /** From a boundary node: inside if the next boundary segment clockwise is an outgoing one. */
    private fun leavesInside(node: Int, to: Int): Boolean {
        val around = windings.sortedAround(node)
        val before = around.lastOrNull { checked.directions.compare(node, windings.otherEnd(node, it), to) < 0 }
        return checked.start(before ?: around.last()) == node
    }
}
