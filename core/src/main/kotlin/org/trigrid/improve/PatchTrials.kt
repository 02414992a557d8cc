package org.trigrid.improve

import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.quality.TriangleQuality

/**
 * Surgery that valences alone do not ask for: done for trial, kept if the smoothed patch around it is better than before.
 *
 * Valence 5 beside 7 is a dislocation of the lattice. Flips that leave the sum of squared deviations as it is move
 * dislocations, which then cancel or come to lie where sizes change; collapses of short edges and splits along long ones
 * make new pairs where the lattice is strained.
 */
internal class PatchTrials(
    private val connectivity: Connectivity,
    private val ideal: IdealValence,
    private val changes: Changes,
    private val splitter: Splitter,
) {
    private val mesh = connectivity.mesh
    private val patch = Patch(connectivity)

    /** Trials that were better and have stayed. */
    var kept = 0
        private set

    /** Tries to flip the edges near which something has changed since the last pass. */
    fun tryFlips(progress: ImproveProgress) {
        val count = 3 * mesh.elementCount
        for (h in 0 until count) {
            progress.tick(h, count)
            if (connectivity.isAlive(h) && mesh.twins[h] > h) tryFlip(h)
        }
    }

    /** Tries to collapse the shortest or to split along the longest edge of each node near which something has changed. */
    fun tryLengths(progress: ImproveProgress) {
        val count = mesh.nodeCount
        for (n in mesh.fixedNodeCount until count) {
            progress.tick(n, count)
            if (connectivity.outgoing[n] >= 0 && changes.isDue(n)) tryLengthsAt(n)
        }
    }

    private fun tryFlip(h: Int) {
        val g = mesh.twins[h]
        val a = mesh.elements[h]
        val b = mesh.elements[g]
        val c = mesh.elements[previous(h)]
        val d = mesh.elements[previous(g)]
        val gain = ideal.flipGain(connectivity.valence, a, b, c, d)
        if (gain < LEAST_GAIN) return
        if (gain < WELCOME && squaredLength(c, d) > longestTurned(gain) * squaredLength(a, b)) return
        if (!(changes.isDue(a) || changes.isDue(b) || changes.isDue(c) || changes.isDue(d))) return
        if (gain < NEUTRAL && Math.min(quality(a, b, c), quality(b, a, d)) > GOOD) return
        if (wouldStarve(a) || wouldStarve(b) || mesh.isEmbedded(a, b)) return
        if (quality(a, d, c) < LEAST_QUALITY || quality(b, c, d) < LEAST_QUALITY) return
        patch.begin(a, b, c, d)
        val before = patch.energy(h / 3, g / 3, NONE)
        if (gain < WELCOME && before < CALM_FLIP) return
        val least = patch.minQuality
        connectivity.flip(h)
        if (isBetter(before, least, h / 3, g / 3, NONE, HOPELESS_FLIP)) return
        connectivity.flip(next(h))
        patch.restore()
    }

    /** The squared length of the turned edge over that of the edge above which a flip has hardly ever been kept. */
    private fun longestTurned(gain: Double): Double = when {
        gain < RAISING -> 1.5
        gain < NEUTRAL -> 1.85
        else -> 2.12
    }

    private fun squaredLength(a: Int, b: Int): Double {
        val dx = mesh.xy[2 * b] - mesh.xy[2 * a]
        val dy = mesh.xy[2 * b + 1] - mesh.xy[2 * a + 1]
        return dx * dx + dy * dy
    }

    /** Whether a free node that loses an element would have 3, or a fixed one none. */
    private fun wouldStarve(node: Int): Boolean =
        connectivity.valence[node] <= if (connectivity.isFree(node)) 4 else 1

    private fun tryLengthsAt(n: Int) {
        val xy = mesh.xy
        val first = connectivity.outgoing[n]
        var shortest = SHORT * SHORT
        var longest = LONG * LONG
        var shortEdge = -1
        var longEdge = -1
        var h = first
        do {
            val m = mesh.elements[next(h)]
            val dx = xy[2 * m] - xy[2 * n]
            val dy = xy[2 * m + 1] - xy[2 * n + 1]
            val size = 0.5 * (mesh.sizes[n] + mesh.sizes[m])
            val ratio = (dx * dx + dy * dy) / (size * size)
            if (ratio < shortest) {
                shortest = ratio
                shortEdge = h
            }
            if (ratio > longest) {
                longest = ratio
                longEdge = h
            }
            h = mesh.twins[previous(h)]
        } while (h != first)
        if (shortEdge >= 0 && tryCollapse(shortEdge)) return
        if (longEdge >= 0) trySplit(n, mesh.elements[next(longEdge)])
    }

    private fun tryCollapse(h: Int): Boolean {
        val n = mesh.elements[h]
        val m = mesh.elements[next(h)]
        val left = mesh.elements[previous(h)]
        val right = mesh.elements[previous(mesh.twins[h])]
        if (wouldStarve(left) || wouldStarve(right)) return false
        val valence = connectivity.valence
        val change = ideal.change(n, valence[n], 6) + ideal.change(m, valence[m], valence[m] + valence[n] - 4) +
            ideal.change(left, valence[left], valence[left] - 1) + ideal.change(right, valence[right], valence[right] - 1)
        if (change > MOST_CHANGE) return false
        val fixed = if (connectivity.isFree(m)) NONE else m
        connectivity.outgoing[m] = mesh.twins[h]
        patch.begin(n, m, left, right)
        val before = patch.energy(NONE, NONE, fixed) - PAIR
        if (before < CALM) return false
        val least = patch.minQuality
        val size = mesh.sizes[n]
        connectivity.collapse(h)
        if (connectivity.isFree(m)) {
            mesh.xy[2 * m] = 0.5 * (mesh.xy[2 * m] + mesh.xy[2 * n])
            mesh.xy[2 * m + 1] = 0.5 * (mesh.xy[2 * m + 1] + mesh.xy[2 * n + 1])
        }
        patch.energy(NONE, NONE, fixed)
        if (patch.minQuality > LEAST_QUALITY && isBetter(before, least, NONE, NONE, fixed, HOPELESS)) return true
        connectivity.undoCollapse(h, n, m, left, right, size)
        patch.restore()
        return false
    }

    private fun trySplit(n: Int, towards: Int) {
        if (!splitter.prepare(n, towards, MOST_CHANGE)) return
        patch.begin(n, towards, splitter.end(false), splitter.end(true))
        val before = patch.energy(NONE, NONE, NONE) + PAIR
        if (before < CALM) return
        val least = patch.minQuality
        val made = splitter.split(n)
        patch.addSeed(made)
        if (isBetter(before, least, NONE, NONE, NONE, HOPELESS)) return
        connectivity.collapse(connectivity.halfEdge(made, n))
        patch.restore()
    }

    /**
     * Smooths the patch and compares with the energy and the least q before the surgery; when it is better, its nodes are due
     * again. The seeds are smoothed alone first, and most trials end there: more than [hopeless] above [before].
     */
    private fun isBetter(before: Double, least: Double, t: Int, s: Int, fixed: Int, hopeless: Double): Boolean {
        patch.smooth()
        patch.smooth()
        if (patch.energy(t, s, fixed) > before + hopeless) return false
        val ofPatch = before + patch.widen()
        val leastOfPatch = Math.min(least, patch.minQuality)
        patch.smooth()
        if (patch.energy(t, s, fixed) > ofPatch + HOPELESS_PATCH) return false
        patch.smooth()
        val isLower = patch.energy(t, s, fixed) < ofPatch - ENOUGH
        if (!isLower || patch.minQuality < Math.min(leastOfPatch, POOR)) return false
        patch.touch(changes)
        kept++
        return true
    }

    private fun quality(a: Int, b: Int, c: Int): Double {
        val xy = mesh.xy
        return TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
    }

    private companion object {
        const val NONE = -1

        /** Flips that raise the squared deviations by 2 are tried too, but only at elements below [GOOD]. */
        const val LEAST_GAIN = -2.01
        const val NEUTRAL = -0.51
        const val RAISING = -1.51
        const val WELCOME = 1.51
        const val GOOD = 0.9

        /** Elements below this before smoothing are not worth a trial. */
        const val LEAST_QUALITY = 0.1

        /** No trial may make the least q worse where it is below this. */
        const val POOR = 0.6

        /** Collapses and splits that raise the squared deviations of the valences by more have hardly ever been kept. */
        const val MOST_CHANGE = 4.5

        /** Where there is less energy around the four nodes to begin with, there is too little to gain. */
        const val CALM_FLIP = 0.45
        const val CALM = 0.5

        /** Gain in energy that is worth a change. */
        const val ENOUGH = 0.001

        /** Energy of the two elements by which a collapse lessens the sum: what a fair pair has. */
        const val PAIR = 0.04

        /**
         * Where the energy is still above that before surgery by this much after the seeds have been smoothed, or the whole
         * patch once, a trial is given up: of those that would be kept in the end 1 in 8 is lost, of the others 19 in 20 end here.
         */
        const val HOPELESS_FLIP = 0.12
        const val HOPELESS = 0.15
        const val HOPELESS_PATCH = 0.05

        /** Edges beyond these shares of their size are tried. */
        const val SHORT = 0.75
        const val LONG = 1.3
    }
}
