package org.trigrid.improve

/**
 * Splits a free node in two where it has too many neighbours or its edges are too long, along the two ring nodes that
 * lack an element most:
 * ```
 *     o---a---o             o---a---o
 *    / \  |  / \           / \ / \ / \
 *   o---node----o   ->    o-new---node-o
 *    \ /  |  \ /           \ / \ / \ /
 *     o---b---o             o---b---o
 * ```
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
    private var bestFirst = -1
    private var bestSpan = 0

    /** Splits the node if that pays. */
    fun tryNode(node: Int): Boolean {
        if (connectivity.valence[node] < LEAST_VALENCE) return false
        star.gather(connectivity, node)
        chooseEnds(node)
        if (bestFirst < 0) return false
        place(bestFirst, bestSpan)
        if (!isGood()) return false
        val made = split(node, bestFirst, bestSpan)
        changes.touch(node)
        changes.touch(made)
        for (i in 0 until star.count) changes.touch(star.ring[i])
        flipper.pushStar(node)
        flipper.pushStar(made)
        return true
    }

    /**
     * Prepares the split of [node] across its edge to [towards], for [split]; false if the elements would be too bad or the
     * squared deviations of the valences grow by more than [mostChange].
     */
    fun prepare(node: Int, towards: Int, mostChange: Double): Boolean {
        if (connectivity.valence[node] < LEAST_VALENCE) return false
        star.gather(connectivity, node)
        var i = 0
        while (star.ring[i] != towards) i++
        bestSpan = star.count / 2
        bestFirst = (i - bestSpan / 2 + star.count) % star.count
        if (valenceChange(node, bestFirst, bestSpan) > mostChange) return false
        place(bestFirst, bestSpan)
        return Math.min(near.minQuality(), far.minQuality()) > LEAST_PREPARED
    }

    /** Does what was prepared and returns the new node. */
    fun split(node: Int): Int = split(node, bestFirst, bestSpan)

    /** The ring node that will be next to both nodes, first or second one. */
    fun end(second: Boolean): Int = star.ring[(bestFirst + if (second) bestSpan else 0) % star.count]

    private fun chooseEnds(node: Int) {
        val d = star.count
        bestFirst = -1
        var bestScore = -EQUAL - LENGTH_WEIGHT * (1 - star.meanDistance() / mesh.sizes[node])
        for (span in 3..d / 2) {
            for (first in 0 until d) {
                val score = valenceChange(node, first, span)
                if (score < bestScore) {
                    bestScore = score
                    bestFirst = first
                    bestSpan = span
                }
            }
        }
    }

    private fun valenceChange(node: Int, first: Int, span: Int): Double {
        val valence = connectivity.valence
        val a = star.ring[first]
        val b = star.ring[(first + span) % star.count]
        return ideal.change(node, star.count, star.count - span + 2) + ideal.change(node, 6, span + 2) +
            ideal.change(a, valence[a], valence[a] + 1) + ideal.change(b, valence[b], valence[b] + 1)
    }

    /** Finds places: the new node gets ring nodes [first] to [first] + [span], the old one the rest and both ends. */
    private fun place(first: Int, span: Int) {
        val d = star.count
        fill(near, first, span)
        fill(far, (first + span) % d, d - span)
        near.x = 0.5 * (star.x + near.x)
        near.y = 0.5 * (star.y + near.y)
        far.x = 0.5 * (star.x + far.x)
        far.y = 0.5 * (star.y + far.y)
        near.add(MADE, far.x, far.y)
        near.close()
        far.add(MADE, near.x, near.y)
        far.close()
        for (round in 0..1) {
            near.smoothingStep()
            setLast(far, near)
            far.smoothingStep()
            setLast(near, far)
        }
    }

    private fun fill(part: Star, first: Int, span: Int) {
        part.clear()
        for (k in 0..span) {
            val i = (first + k) % star.count
            part.add(star.ring[i], star.xy[2 * i], star.xy[2 * i + 1])
        }
        part.centre()
    }

    private fun setLast(part: Star, other: Star) {
        part.xy[2 * part.count - 2] = other.x
        part.xy[2 * part.count - 1] = other.y
    }

    private fun isGood(): Boolean {
        val after = Math.min(near.minQuality(), far.minQuality())
        if (!QualityGuard.allows(star.minQuality(), after, LEAST_QUALITY, LEAST_SHARE)) return false
        // The two elements between the old and the new node are in both stars.
        val sum = near.sumQuality() + far.sumQuality() - near.quality(near.count - 1) - near.quality(near.count - 2)
        return sum / (star.count + 2) > star.sumQuality() / star.count - MEAN_SLACK
    }

    private fun split(node: Int, first: Int, span: Int): Int {
        val d = star.count
        val middle = span / 2
        val h = connectivity.halfEdge(node, star.ring[(first + middle) % d])
        val made = connectivity.split(h, near.x, near.y, mesh.sizes[node])
        mesh.xy[2 * node] = far.x
        mesh.xy[2 * node + 1] = far.y
        // The new node has one ring node to either side of the middle; flips of the old node's edges give it the others.
        for (k in middle + 1 until span) flipTo(node, star.ring[(first + k) % d])
        for (k in middle - 1 downTo 1) flipTo(node, star.ring[(first + k) % d])
        return made
    }

    private fun flipTo(node: Int, ringNode: Int) = connectivity.flip(connectivity.halfEdge(node, ringNode))

    private companion object {
        const val EQUAL = 1e-9

        /** A node with fewer neighbours would be split into nodes of valence 4. */
        const val LEAST_VALENCE = 6
        const val LEAST_QUALITY = 0.7
        const val LEAST_SHARE = 0.9
        const val LEAST_PREPARED = 0.3

        /** The mean q may fall by this much; smoothing regains it. */
        const val MEAN_SLACK = 0.015

        /** What edges of twice their wanted length weigh in squared deviations of valences. */
        const val LENGTH_WEIGHT = 4.0

        /** Stands in a ring for a node that is not yet there. */
        const val MADE = -1
    }
}
