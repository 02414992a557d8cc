package org.trigrid.improve

import org.trigrid.improve.Connectivity.Companion.next
import org.trigrid.improve.Connectivity.Companion.previous
import org.trigrid.quality.TriangleQuality

/**
 * Removes free nodes by pulling them into a neighbour: nodes of low valence, short edges, and the 5-5 edges between two
 * nodes of valence 7 or more, where the surplus and the lack cancel.
 */
internal class Collapser(
    private val connectivity: Connectivity,
    private val ideal: IdealValence,
    private val changes: Changes,
    private val flipper: Flipper,
) {
    private val mesh = connectivity.mesh
    private val star = Star()
    private val other = Star()
    private val merged = Star()

    /** Removes the node if that pays. */
    fun tryNode(node: Int): Boolean {
        val valence = connectivity.valence
        star.gather(connectivity, node)
        val count = star.count
        val xy = mesh.xy
        var meanLength = 0.0
        for (i in 0 until count) {
            meanLength += Math.hypot(star.xy[2 * i] - star.x, star.xy[2 * i + 1] - star.y)
        }
        meanLength /= count * mesh.sizes[node]
        val own = -(count - 6.0) * (count - 6.0)
        var best = -1
        var bestScore = -EQUAL
        for (i in 0 until count) {
            val m = star.ring[i]
            val left = star.ring[if (i + 1 == count) 0 else i + 1]
            val right = star.ring[if (i == 0) count - 1 else i - 1]
            if (isTooFew(left) || isTooFew(right)) continue
            val length = Math.hypot(xy[2 * m] - star.x, xy[2 * m + 1] - star.y) / mesh.sizes[node]
            val change = own + ideal.change(m, valence[m], valence[m] + count - 4) +
                ideal.change(left, valence[left], valence[left] - 1) + ideal.change(right, valence[right], valence[right] - 1)
            val score = change + LENGTH_WEIGHT * (0.5 * (length + meanLength) - LENGTH_PIVOT)
            if (score < bestScore) {
                bestScore = score
                best = i
            }
        }
        return best >= 0 && collapse(node, best)
    }

    private fun collapse(node: Int, at: Int): Boolean {
        val m = star.ring[at]
        val count = star.count
        var before = star.minQuality(star.x, star.y)
        merged.clear()
        for (k in 1 until count) {
            val i = (at + k) % count
            merged.add(star.ring[i], star.xy[2 * i], star.xy[2 * i + 1])
        }
        val after: Double
        var sumBefore = star.sumQuality(star.x, star.y)
        var countBefore = count
        val sumAfter: Double
        if (connectivity.isFree(m)) {
            other.gather(connectivity, m)
            before = minOf(before, other.minQuality(other.x, other.y))
            sumBefore += other.sumQuality(other.x, other.y) - star.quality(at) - star.quality(if (at == 0) count - 1 else at - 1)
            countBefore += other.count - 2
            var start = 0
            while (other.ring[start] != node) start++
            // From the node, the ring of m runs over the right neighbour to the left one.
            for (k in 2..other.count - 2) {
                val i = (start + k) % other.count
                merged.add(other.ring[i], other.xy[2 * i], other.xy[2 * i + 1])
            }
            merged.close()
            merged.x = 0.5 * (star.x + other.x)
            merged.y = 0.5 * (star.y + other.y)
            if (merged.minQuality(merged.x, merged.y) <= 0.0) merged.centre()
            merged.newtonStep()
            merged.newtonStep()
            after = merged.minQuality(merged.x, merged.y)
            sumAfter = merged.sumQuality(merged.x, merged.y)
        } else {
            merged.x = mesh.xy[2 * m]
            merged.y = mesh.xy[2 * m + 1]
            var least = 2.0
            var sum = 0.0
            for (i in 0..count - 3) {
                val q = TriangleQuality.shape(
                    merged.x, merged.y, merged.xy[2 * i], merged.xy[2 * i + 1], merged.xy[2 * i + 2], merged.xy[2 * i + 3],
                )
                if (q < least) least = q
                sum += q
            }
            sumAfter = sum
            after = least
        }
        if (after < Star.SURELY_POSITIVE || !(after >= before || after > LEAST_QUALITY && after > LEAST_SHARE * before)) return false
        if (sumAfter / (countBefore - 2) < sumBefore / countBefore - SLACK) return false
        for (k in 0 until merged.count) {
            val i = merged.ring[k]
            if (Math.hypot(merged.xy[2 * k] - merged.x, merged.xy[2 * k + 1] - merged.y) > LONGEST * 0.5 * (mesh.sizes[i] + mesh.sizes[m])) return false
        }
        var h = connectivity.outgoing[node]
        while (mesh.elements[next(h)] != m) h = mesh.twins[previous(h)]
        connectivity.collapse(h)
        for (k in 0 until merged.count) changes.touch(merged.ring[k])
        changes.touch(m)
        if (connectivity.isFree(m)) {
            mesh.xy[2 * m] = merged.x
            mesh.xy[2 * m + 1] = merged.y
            flipper.pushStar(m)
        } else {
            for (k in 0 until merged.count) if (connectivity.isFree(merged.ring[k])) flipper.pushStar(merged.ring[k])
        }
        return true
    }

    private fun isTooFew(node: Int): Boolean = connectivity.valence[node] <= if (connectivity.isFree(node)) 3 else 1

    companion object {
        private const val EQUAL = 1e-9
        @JvmField var LEAST_QUALITY = 0.7
        @JvmField var LEAST_SHARE = 0.9

        @JvmField var SLACK = 0.015

        /** No edge may grow beyond this times its size. */
        private const val LONGEST = 1.6

        /** Valence changes weighed against edge length over size. */
        @JvmField var LENGTH_WEIGHT = 4.0
        @JvmField var LENGTH_PIVOT = 1.0
    }
}
