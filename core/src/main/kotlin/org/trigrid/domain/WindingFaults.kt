package org.trigrid.domain

import org.locationtech.jts.geom.Envelope
import org.trigrid.diagnostics.FaultKind

/**
 * Faults of how loops lie to one another: the winding number must be 1 on the left of every segment and 0 on its right.
 *
 * At a node of several loops, segments out and in must take turns; then the winding numbers along a connected part of
 * the boundary are everywhere the same, and one place of each part is enough. All tests are exact. Parts with an open
 * walk have no inside and are left aside.
 */
internal class WindingFaults(
    private val checked: CheckedDomain,
    private val parts: BoundaryParts,
    /** Per tested segment. Not modified. */
    isFaulty: BooleanArray,
    private val faults: FaultList,
) {
    private val xy = checked.xy
    private val directions = checked.directions

    /** Per part's representative: whether it has faults that make its winding numbers meaningless. */
    private val skipped = BooleanArray(checked.domain.nodeCount)

    /** The box round all parts with open walks, in which nobody can say what is outside. */
    private val openBox = Envelope()

    init {
        for (t in 0 until checked.boundaryCount) if (isFaulty[t]) skipped[parts.partOf(checked.start(t))] = true
        for (node in skipped.indices) {
            checked.checkpoint.pass()
            if (!parts.isOpen(node)) continue
            skipped[parts.partOf(node)] = true
            if (checked.isFinite(node)) openBox.expandToInclude(xy[2 * node], xy[2 * node + 1])
        }
    }

    fun find() {
        for (node in skipped.indices) {
            checked.checkpoint.pass()
            if (checked.leaving.countAt(node) > 1 && !parts.isOpen(node)) examineNode(node)
        }
        val corners = lowestLeftCorners()
        for (part in corners.indices) {
            checked.checkpoint.pass()
            if (corners[part] >= 0 && !skipped[part]) examinePart(corners[part])
        }
    }

    /** Whether a place that no segment touches lies in the domain, as far as that can be said. */
    fun isInside(place: Int): Boolean = isNearOpenWalk(place) || windingLeftOf(place) == 1

    private fun isNearOpenWalk(place: Int) = openBox.covers(xy[2 * place], xy[2 * place + 1])

    /** Whether the neighbourhood of [place] is free of faults, so that sides can be told there. */
    fun isTrusted(place: Int): Boolean = !skipped[parts.partOf(place)]

    /** Boundary segments at a place, by the angle of their other ends; ties by number. */
    fun sortedAround(place: Int): List<Int> {
        val around = ArrayList<Int>()
        checked.leaving.forEachAt(place) { around.add(it) }
        checked.arriving.forEachAt(place) { around.add(it) }
        around.sortWith { s, t ->
            val byAngle = directions.compare(place, otherEnd(place, s), otherEnd(place, t))
            if (byAngle != 0) byAngle else s - t
        }
        return around
    }

    fun otherEnd(place: Int, t: Int): Int = if (checked.start(t) == place) checked.end(t) else checked.start(t)

    private fun examineNode(place: Int) {
        val around = sortedAround(place)
        val turns = around.indices.all { isOut(place, around[it]) != isOut(place, around[(it + 1) % around.size]) }
        val wasSkipped = skipped[parts.partOf(place)]
        if (turns || wasSkipped && hasEqualDirections(place, around)) return
        skipped[parts.partOf(place)] = true
        var winding = windingLeftOf(place)
        var highest = winding
        var lowest = winding
        val first = around.indexOfFirst { xy[2 * otherEnd(place, it) + 1] <= xy[2 * place + 1] && !isRight(place, it) }
        for (i in around.indices) {
            winding += if (isOut(place, around[(Math.max(first, 0) + i) % around.size])) 1 else -1
            highest = Math.max(highest, winding)
            lowest = Math.min(lowest, winding)
        }
        if (highest > 1) {
            fault(FaultKind.OVERLAP, place, "loops that meet in node ${checked.nodeText(place)} cover the same place")
        }
        if (lowest < 0) {
            fault(FaultKind.HOLE_OUTSIDE, place, "a hole that meets node ${checked.nodeText(place)} has no material round it")
        }
    }

    /** Whether the segment runs from [place] straight along the positive x-axis. */
    private fun isRight(place: Int, t: Int): Boolean {
        val other = otherEnd(place, t)
        return xy[2 * other + 1] == xy[2 * place + 1] && xy[2 * other] > xy[2 * place]
    }

    private fun hasEqualDirections(place: Int, around: List<Int>): Boolean =
        (1 until around.size).any { directions.compare(place, otherEnd(place, around[it - 1]), otherEnd(place, around[it])) == 0 }

    private fun isOut(place: Int, t: Int) = checked.start(t) == place

    /** The lowest of the leftmost places of each part, or -1. */
    private fun lowestLeftCorners(): IntArray {
        val corners = IntArray(checked.domain.nodeCount).also { it.fill(-1) }
        for (t in 0 until checked.boundaryCount) {
            checked.checkpoint.pass()
            val place = checked.start(t)
            val part = parts.partOf(place)
            val corner = corners[part]
            if (corner < 0 || isLeftOrBelow(place, corner)) corners[part] = place
        }
        return corners
    }

    private fun isLeftOrBelow(a: Int, b: Int) = xy[2 * a] < xy[2 * b] || xy[2 * a] == xy[2 * b] && xy[2 * a + 1] < xy[2 * b + 1]

    /** Left of [corner] the part has no segment: its first one anticlockwise from there tells which side that is. */
    private fun examinePart(corner: Int) {
        val around = sortedAround(corner)
        val first = around.firstOrNull { xy[2 * otherEnd(corner, it) + 1] < xy[2 * corner + 1] } ?: around[0]
        val winding = windingLeftOf(corner)
        val isHole = !isOut(corner, first)
        if (isHole && winding < 1) {
            if (isNearOpenWalk(corner)) return
            fault(FaultKind.HOLE_OUTSIDE, corner, "the hole at node ${checked.nodeText(corner)} has no material round it")
        } else if (isHole && winding > 1 || !isHole && winding > 0) {
            fault(FaultKind.OVERLAP, corner, "the loop at node ${checked.nodeText(corner)} lies where another covers the place")
        }
    }

    private fun fault(kind: FaultKind, place: Int, message: String) =
        faults.add(kind, xy[2 * place], xy[2 * place + 1], intArrayOf(place)) { message }

    /**
     * Winding number just left of [place] and, by a much smaller step, above: there a ray to the left meets no node, and
     * none of the segments that end in the place.
     */
    private fun windingLeftOf(place: Int): Int {
        val y = xy[2 * place + 1]
        var winding = 0
        checked.tree.forEachIn(Double.NEGATIVE_INFINITY, y, xy[2 * place], y) { t ->
            val a = checked.start(t)
            val b = checked.end(t)
            val goesUp = xy[2 * a + 1] <= y
            if (!checked.isEmbedded(t) && goesUp != (xy[2 * b + 1] <= y) && !parts.isOpen(a)) {
                val side = directions.orient(a, b, place)
                if (goesUp && side < 0) winding--
                if (!goesUp && side > 0) winding++
            }
        }
        return winding
    }
}
