package org.trigrid.domain

/**
 * Finds where the domain is narrower than the boundary segments beside it are long.
 *
 * A segment of length h with a node of another stretch before it at distance d < h forces an angle of about d/h.
 * Round a corner that is always so; a gap counts only if it is a fifth of the way along the boundary, or less.
 */
internal class GapSearch(private val checked: CheckedDomain) {
    private val domain = checked.domain
    private val xy = checked.xy
    private val count = domain.boundaryCount
    private val loopOf = IntArray(count)

    /** Length along the loop from its first node to the segment's start. */
    private val position = DoubleArray(count)
    private val loopLength = DoubleArray(domain.loopCount)
    private val parts = BoundaryParts(checked)

    /** Per segment, for its start node: the segment before it that is relatively closest, or -1, and how close. */
    private val closest = IntArray(count).also { it.fill(-1) }
    private val share = DoubleArray(count) { 1.0 }

    /** A narrow place: [width] between [node] and [segment], and its share of the segment's length. */
    class Gap(val node: Int, val segment: Int, val width: Double, val share: Double, val sameLoop: Boolean)

    /** The narrowest place of each narrow stretch. */
    fun find(): List<Gap> {
        measureLoops()
        for (t in 0 until count) examine(t)
        val gaps = ArrayList<Gap>()
        for (loop in 0 until domain.loopCount) collect(loop, gaps)
        return gaps
    }

    private fun measureLoops() {
        for (loop in 0 until domain.loopCount) {
            var length = 0.0
            for (s in domain.loopStart(loop) until domain.loopStart(loop + 1)) {
                loopOf[s] = loop
                position[s] = length
                length += length(s)
            }
            loopLength[loop] = length
        }
    }

    private fun examine(t: Int) {
        val a = checked.start(t)
        val b = checked.end(t)
        val h = length(t)
        checked.tree.forEachIn(
            Math.min(xy[2 * a], xy[2 * b]) - h, Math.min(xy[2 * a + 1], xy[2 * b + 1]) - h,
            Math.max(xy[2 * a], xy[2 * b]) + h, Math.max(xy[2 * a + 1], xy[2 * b + 1]) + h,
        ) { s -> if (s < count) examine(s, t, h) }
    }

    /** The start node of [s] against segment [t] of length [h]. */
    private fun examine(s: Int, t: Int, h: Double) {
        val node = checked.start(s)
        if (node == checked.start(t) || node == checked.end(t)) return
        val apart = distance(node, t)
        if (apart >= share[s] * h || !isBefore(node, s, t)) return
        if (loopOf[s] != loopOf[t] && parts.partOf(node) == parts.partOf(checked.start(t))) return
        if (loopOf[s] == loopOf[t] && apart > CORNER_SHARE * alongLoop(s, t)) return
        closest[s] = t
        share[s] = apart / h
    }

    /** Whether the node lies on the domain's side of [t], and t, roughly, on the domain's side of the node. */
    private fun isBefore(node: Int, s: Int, t: Int): Boolean {
        val a = checked.start(t)
        val b = checked.end(t)
        if (checked.directions.orient(a, b, node) <= 0) return false
        return checked.directions.orient(node, checked.end(s), a) > 0 || checked.directions.orient(node, checked.end(s), b) > 0
    }

    private fun alongLoop(s: Int, t: Int): Double {
        val whole = loopLength[loopOf[s]]
        val forward = Math.abs(position[s] - position[t])
        val fromEnd = Math.abs(position[s] - position[t] - length(t))
        return minOf(minOf(forward, whole - forward), minOf(fromEnd, Math.abs(whole - fromEnd)))
    }

    private fun collect(loop: Int, gaps: MutableList<Gap>) {
        var best = -1
        for (s in domain.loopStart(loop) until domain.loopStart(loop + 1)) {
            val goesOn = best >= 0 && closest[s] >= 0 && loopOf[closest[s]] == loopOf[closest[best]]
            if (best >= 0 && !goesOn) {
                gaps.add(gap(best))
                best = -1
            }
            if (closest[s] >= 0 && (best < 0 || share[s] < share[best])) best = s
        }
        if (best >= 0) gaps.add(gap(best))
    }

    private fun gap(s: Int): Gap {
        val t = closest[s]
        return Gap(checked.nodeAtStart(s), t, distance(checked.start(s), t), share[s], loopOf[s] == loopOf[t])
    }

    private fun distance(node: Int, t: Int): Double {
        val ax = xy[2 * checked.start(t)]
        val ay = xy[2 * checked.start(t) + 1]
        val dx = xy[2 * checked.end(t)] - ax
        val dy = xy[2 * checked.end(t) + 1] - ay
        val px = xy[2 * node] - ax
        val py = xy[2 * node + 1] - ay
        val along = Math.max(0.0, Math.min(1.0, (px * dx + py * dy) / (dx * dx + dy * dy)))
        return Math.hypot(px - along * dx, py - along * dy)
    }

    private fun length(t: Int): Double {
        val a = checked.start(t)
        val b = checked.end(t)
        return Math.hypot(xy[2 * b] - xy[2 * a], xy[2 * b + 1] - xy[2 * a + 1])
    }

    private companion object {
        const val CORNER_SHARE = 0.2
    }
}
