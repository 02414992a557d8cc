package org.trigrid.domain

import org.trigrid.diagnostics.FaultKind

/** Embedded segments and points that do not lie in the domain, and points on segments. Decided exactly. */
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

    /** Points that are nodes of a segment are no concern; two points at one place have one number. */
    fun findPoints() {
        for (node in checked.domain.segmentNodeCount until checked.domain.nodeCount) {
            checked.checkpoint.pass()
            if (!checked.isFinite(node) || checked.place[node] != node) continue
            val segment = segmentAt(node)
            val x = xy[2 * node]
            val y = xy[2 * node + 1]
            if (segment >= 0) {
                val nodes = intArrayOf(node, checked.nodeAtStart(segment), checked.nodeAtEnd(segment))
                faults.add(FaultKind.TOUCHING, x, y, nodes) {
                    "embedded point ${checked.nodeText(node)} lies inside segment ${checked.segmentText(segment)}"
                }
            } else if (!windings.isInside(node)) {
                faults.add(FaultKind.EMBEDDED_OUTSIDE, x, y, intArrayOf(node)) {
                    "embedded point ${checked.nodeText(node)} lies outside of the domain"
                }
            }
        }
    }

    /** The first segment that the node lies on, or -1. */
    private fun segmentAt(node: Int): Int {
        val x = xy[2 * node]
        val y = xy[2 * node + 1]
        var found = -1
        checked.tree.forEachIn(x, y, x, y) { t ->
            if ((found < 0 || t < found) && checked.directions.orient(checked.start(t), checked.end(t), node) == 0.0) found = t
        }
        return found
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
