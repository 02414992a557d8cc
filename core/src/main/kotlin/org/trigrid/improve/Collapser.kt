package org.trigrid.improve

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
        star.gather(connectivity, node)
        val at = best(node)
        if (at < 0) return false
        val m = star.ring[at]
        merge(m, at)
        if (!isGood(m, at)) return false
        connectivity.collapse(connectivity.halfEdge(node, m))
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

    /** Index in the ring of the neighbour that it pays most to pull the node into, by valences and lengths, or -1. */
    private fun best(node: Int): Int {
        val valence = connectivity.valence
        val count = star.count
        val size = mesh.sizes[node]
        val meanLength = star.meanDistance() / size
        val own = ideal.change(node, count, 6)
        var best = -1
        var bestScore = -EQUAL
        for (i in 0 until count) {
            val m = star.ring[i]
            val left = star.ring[if (i + 1 == count) 0 else i + 1]
            val right = star.ring[if (i == 0) count - 1 else i - 1]
            if (connectivity.isAtLeast(left) || connectivity.isAtLeast(right)) continue
            val change = own + ideal.change(m, valence[m], valence[m] + count - 4) +
                ideal.change(left, valence[left], valence[left] - 1) + ideal.change(right, valence[right], valence[right] - 1)
            val length = 0.5 * (star.distance(i) / size + meanLength)
            val score = change + LENGTH_WEIGHT * (length - 1)
            if (score < bestScore) {
                bestScore = score
                best = i
            }
        }
        return best
    }

    /** Makes the ring of [m] after the collapse and, if it is free, finds its new place. */
    private fun merge(m: Int, at: Int) {
        merged.clear()
        for (k in 1 until star.count) addTo(merged, star, (at + k) % star.count)
        if (!connectivity.isFree(m)) {
            merged.x = mesh.xy[2 * m]
            merged.y = mesh.xy[2 * m + 1]
            return
        }
        other.gather(connectivity, m)
        // The ring of m holds the node between the left and the right neighbour, which are in the ring already.
        val right = merged.ring[merged.count - 1]
        var start = 0
        while (other.ring[start] != right) start++
        for (k in 1..other.count - 3) addTo(merged, other, (start + k) % other.count)
        merged.close()
        merged.x = 0.5 * (star.x + other.x)
        merged.y = 0.5 * (star.y + other.y)
        if (merged.minQuality() <= 0.0) merged.centre()
        merged.smoothingStep()
        merged.smoothingStep()
    }

    private fun addTo(ring: Star, from: Star, i: Int) = ring.add(from.ring[i], from.xy[2 * i], from.xy[2 * i + 1])

    /** Compares the elements that go with those that come, by their least and mean q and their longest edge. */
    private fun isGood(m: Int, at: Int): Boolean {
        var before = star.minQuality()
        var sumBefore = star.sumQuality()
        var countBefore = star.count
        if (connectivity.isFree(m)) {
            before = Math.min(before, other.minQuality())
            sumBefore += other.sumQuality() - star.quality(at) - star.quality(if (at == 0) star.count - 1 else at - 1)
            countBefore += other.count - 2
        }
        var after = 2.0
        var sumAfter = 0.0
        // A fixed node gets a fan of elements, a free one a closed star.
        for (i in 0 until countBefore - 2) {
            val q = merged.quality(i)
            after = Math.min(after, q)
            sumAfter += q
        }
        if (!QualityGuard.allows(before, after, LEAST_QUALITY, LEAST_SHARE)) return false
        if (sumAfter / (countBefore - 2) < sumBefore / countBefore - MEAN_SLACK) return false
        for (i in 0 until merged.count) {
            val size = 0.5 * (mesh.sizes[merged.ring[i]] + mesh.sizes[m])
            if (merged.distance(i) > LONGEST * size) return false
        }
        return true
    }

    private companion object {
        const val EQUAL = 1e-9
        const val LEAST_QUALITY = 0.7
        const val LEAST_SHARE = 0.9

        /** The mean q may fall by this much; smoothing regains it. */
        const val MEAN_SLACK = 0.015

        /** No edge may grow beyond this times its size. */
        const val LONGEST = 1.6

        /** What an edge of twice its wanted length weighs in squared deviations of valences. */
        const val LENGTH_WEIGHT = 4.0
    }
}
