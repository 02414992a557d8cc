package org.trigrid.improve

import org.trigrid.improve.Connectivity.Companion.next
import org.trigrid.improve.Connectivity.Companion.previous

/**
 * Adds nodes where a free node has too many neighbours or its edges are too long: the node is split in two along the
 * two ring nodes that lack an element most.
 */
internal class Splitter(
    private val connectivity: Connectivity,
    private val ideal: IdealValence,
    private val changes: Changes,
    private val flipper: Flipper,
) {
    private val mesh = connectivity.mesh
    private val star = Star()
    private val near = Star()
    private val far = Star()

    /** Splits the node if that pays. */
    fun tryNode(node: Int): Boolean {
        val d = connectivity.valence[node]
        if (d < 6) return false
        star.gather(connectivity, node)
        var meanLength = 0.0
        for (i in 0 until d) meanLength += Math.hypot(star.xy[2 * i] - star.x, star.xy[2 * i + 1] - star.y)
        meanLength /= d * mesh.sizes[node]
        var bestFirst = -1
        var bestSpan = 0
        var bestScore = -EQUAL - LENGTH_WEIGHT * (LENGTH_PIVOT - meanLength)
        val valence = connectivity.valence
        for (span in 3..d / 2) {
            val mine = d - span + 2
            val change = (span + 2 - 6.0) * (span + 2 - 6.0) + (mine - 6.0) * (mine - 6.0) - (d - 6.0) * (d - 6.0)
            for (first in 0 until d) {
                val a = star.ring[first]
                val b = star.ring[(first + span) % d]
                val score = change + ideal.change(a, valence[a], valence[a] + 1) + ideal.change(b, valence[b], valence[b] + 1)
                if (score < bestScore) {
                    bestScore = score
                    bestFirst = first
                    bestSpan = span
                }
            }
        }
        return bestFirst >= 0 && split(node, bestFirst, bestSpan)
    }

    private fun split(node: Int, first: Int, span: Int): Boolean {
        val d = star.count
        val before = star.minQuality(star.x, star.y)
        // The new node gets ring nodes first .. first + span, the old one the rest and both ends.
        fill(near, first, span)
        fill(far, (first + span) % d, d - span)
        val oldX = star.x
        val oldY = star.y
        near.centre()
        far.centre()
        near.x = 0.5 * (oldX + near.x)
        near.y = 0.5 * (oldY + near.y)
        far.x = 0.5 * (oldX + far.x)
        far.y = 0.5 * (oldY + far.y)
        near.add(node, far.x, far.y)
        near.close()
        far.add(-1, near.x, near.y)
        far.close()
        for (round in 0..1) {
            near.newtonStep()
            setLast(far, near.x, near.y)
            far.newtonStep()
            setLast(near, far.x, far.y)
        }
        val after = minOf(near.minQuality(near.x, near.y), far.minQuality(far.x, far.y))
        if (after < Star.SURELY_POSITIVE || !(after >= before || after > LEAST_QUALITY && after > LEAST_SHARE * before)) return false
        val sumAfter = near.sumQuality(near.x, near.y) + far.sumQuality(far.x, far.y) - near.quality(near.count - 1) - near.quality(near.count - 2)
        if (sumAfter / (d + 2) < star.sumQuality(star.x, star.y) / d - SLACK) return false
        val middle = star.ring[(first + span / 2) % d]
        var h = connectivity.outgoing[node]
        while (mesh.elements[next(h)] != middle) h = mesh.twins[previous(h)]
        val new = connectivity.split(h, near.x, near.y, mesh.sizes[node])
        mesh.xy[2 * node] = far.x
        mesh.xy[2 * node + 1] = far.y
        // The new node has one ring node to either side of the middle; flips of the old node's edges give it the others.
        for (k in span / 2 + 2..span) flipTo(node, star.ring[(first + k - 1) % d])
        for (k in span / 2 - 2 downTo 0) flipTo(node, star.ring[(first + k + 1) % d])
        changes.touch(node)
        changes.touch(new)
        for (i in 0 until d) changes.touch(star.ring[i])
        flipper.pushStar(node)
        flipper.pushStar(new)
        return true
    }

    private fun flipTo(node: Int, ringNode: Int) {
        var h = connectivity.outgoing[node]
        while (mesh.elements[next(h)] != ringNode) h = mesh.twins[previous(h)]
        connectivity.flip(h)
    }

    private fun fill(part: Star, first: Int, span: Int) {
        part.clear()
        for (k in 0..span) {
            val i = (first + k) % star.count
            part.add(star.ring[i], star.xy[2 * i], star.xy[2 * i + 1])
        }
    }

    private fun setLast(part: Star, x: Double, y: Double) {
        part.xy[2 * part.count - 2] = x
        part.xy[2 * part.count - 1] = y
    }

    companion object {
        private const val EQUAL = 1e-9
        @JvmField var LEAST_QUALITY = 0.7
        @JvmField var LEAST_SHARE = 0.9
        @JvmField var SLACK = 0.015
        @JvmField var LENGTH_WEIGHT = 4.0
        @JvmField var LENGTH_PIVOT = 1.0
    }
}
