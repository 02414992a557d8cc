package org.trigrid.domain

import org.locationtech.jts.algorithm.RobustLineIntersector
import org.locationtech.jts.geom.Coordinate
import org.trigrid.diagnostics.FaultKind
import org.trigrid.geometry.IntList

/**
 * Faults between two segments: crossing, touching, overlap and spikes.
 *
 * Which fault it is, exact signs decide; only the coordinates of a crossing are rounded. A pair that shares an end is
 * faulty only where both run the same way from it.
 */
internal class PairFaults(private val checked: CheckedDomain, private val faults: FaultList) {
    private val xy = checked.xy
    private val intersector = RobustLineIntersector()

    /** 2 per touch: node and segment. Told at the end, when all overlaps are known. */
    private val touches = IntList()

    /** Place and segment of each touch that needs no telling: told already, or part of an overlap. */
    private val told = HashSet<Long>()
    private var faultyPairs = 0

    /** 2 per pair of boundary segments that run the same way in opposite directions. */
    private val turnBacks = IntList()

    /** Per tested segment: whether it takes part in a fault. */
    val isFaulty: BooleanArray = BooleanArray(checked.tested.size)

    fun find() {
        checked.tree.visitPairs { s, t ->
            checked.checkpoint.pass()
            examine(s, t)
            faultyPairs < PAIR_LIMIT
        }
        for (i in 0 until touches.size step 2) touch(touches[i], touches[i + 1])
        Whiskers(checked, turnBacks.toArray(), faults).find()
    }

    private fun examine(s: Int, t: Int) {
        val a = checked.start(s)
        val b = checked.end(s)
        val c = checked.start(t)
        val d = checked.end(t)
        when {
            a == c -> if (b == d) overlap(s, t) else examineFork(a, b, d, s, t)
            b == d -> examineFork(b, a, c, s, t)
            a == d -> if (b == c) turnBack(s, t) else examineFork(a, b, c, s, t)
            b == c -> examineFork(b, a, d, s, t)
            else -> examineApart(s, t)
        }
    }

    /** Segments that share [tip] and end in [u] and [v]. */
    private fun examineFork(tip: Int, u: Int, v: Int, s: Int, t: Int) {
        if (!sameSide(2 * tip, 2 * u, 2 * v) || !sameSide(2 * tip + 1, 2 * u + 1, 2 * v + 1)) return
        if (checked.directions.orient(tip, u, v) != 0.0) return
        val bothBoundary = !checked.isEmbedded(s) && !checked.isEmbedded(t)
        val isSpike = bothBoundary && checked.leaving.countAt(tip) == 1 && checked.arriving.countAt(tip) == 1
        if (!isSpike) return overlap(s, t)
        markFaulty(s, t)
        silenceTouches(s, t)
        faults.add(FaultKind.SPIKE, xy[2 * tip], xy[2 * tip + 1], intArrayOf(tip, u, v)) {
            "the boundary runs to node ${checked.nodeText(tip)} and straight back"
        }
    }

    private fun sameSide(tip: Int, u: Int, v: Int): Boolean =
        if (xy[u] > xy[tip]) xy[v] > xy[tip] else if (xy[u] < xy[tip]) xy[v] < xy[tip] else xy[v] == xy[tip]

    private fun turnBack(s: Int, t: Int) {
        if (checked.isEmbedded(s) || checked.isEmbedded(t)) return overlap(s, t)
        markFaulty(s, t)
        turnBacks.add(s)
        turnBacks.add(t)
    }

    private fun examineApart(s: Int, t: Int) {
        val a = checked.start(s)
        val b = checked.end(s)
        val c = checked.start(t)
        val d = checked.end(t)
        val sideC = checked.directions.orient(a, b, c)
        val sideD = checked.directions.orient(a, b, d)
        if (sideC > 0 && sideD > 0 || sideC < 0 && sideD < 0) return
        val sideA = checked.directions.orient(c, d, a)
        val sideB = checked.directions.orient(c, d, b)
        if (sideA > 0 && sideB > 0 || sideA < 0 && sideB < 0) return
        if (sideC == 0.0 && sideD == 0.0) {
            if (overlapInLine(a, b, c, d)) overlap(s, t)
            return
        }
        if (sideC == 0.0) touchIfInside(checked.nodeAtStart(t), c, s, t)
        if (sideD == 0.0) touchIfInside(checked.nodeAtEnd(t), d, s, t)
        if (sideA == 0.0) touchIfInside(checked.nodeAtStart(s), a, t, s)
        if (sideB == 0.0) touchIfInside(checked.nodeAtEnd(s), b, t, s)
        if (sideA != 0.0 && sideB != 0.0 && sideC != 0.0 && sideD != 0.0) crossing(s, t)
    }

    /** Whether segments on one line share more than a place. */
    private fun overlapInLine(a: Int, b: Int, c: Int, d: Int): Boolean {
        val axis = if (xy[2 * a] != xy[2 * b]) 0 else 1
        val low = Math.max(Math.min(xy[2 * a + axis], xy[2 * b + axis]), Math.min(xy[2 * c + axis], xy[2 * d + axis]))
        val high = Math.min(Math.max(xy[2 * a + axis], xy[2 * b + axis]), Math.max(xy[2 * c + axis], xy[2 * d + axis]))
        return low < high
    }

    /** For a [node], of place [p] and segment [own], on the line of segment [other] and not at its ends. */
    private fun touchIfInside(node: Int, p: Int, other: Int, own: Int) {
        val a = checked.start(other)
        val b = checked.end(other)
        if (!isBetween(xy[2 * p], xy[2 * a], xy[2 * b]) || !isBetween(xy[2 * p + 1], xy[2 * a + 1], xy[2 * b + 1])) return
        markFaulty(other, own)
        touches.add(node)
        touches.add(other)
    }

    private fun touch(node: Int, other: Int) {
        val p = checked.place[node]
        if (!told.add(key(p, other))) return
        val nodes = intArrayOf(p, checked.nodeAtStart(other), checked.nodeAtEnd(other))
        faults.add(FaultKind.TOUCHING, xy[2 * p], xy[2 * p + 1], nodes) {
            "node ${checked.nodeText(node)} lies inside segment ${checked.segmentText(other)}"
        }
    }

    private fun key(place: Int, segment: Int): Long = (place.toLong() shl 32) or segment.toLong()

    private fun isBetween(value: Double, a: Double, b: Double) = value >= Math.min(a, b) && value <= Math.max(a, b)

    private fun crossing(s: Int, t: Int) {
        markFaulty(s, t)
        intersector.computeIntersection(
            coordinate(checked.start(s)), coordinate(checked.end(s)), coordinate(checked.start(t)), coordinate(checked.end(t)),
        )
        val place = intersector.getIntersection(0)
        faults.add(FaultKind.CROSSING, place.x, place.y, fourNodes(s, t)) {
            "segments ${checked.segmentText(s)} and ${checked.segmentText(t)} cross at (${place.x}, ${place.y})"
        }
    }

    private fun overlap(s: Int, t: Int) {
        markFaulty(s, t)
        silenceTouches(s, t)
        val inner = innerEnd(s, t)
        faults.add(FaultKind.OVERLAP, xy[2 * inner], xy[2 * inner + 1], fourNodes(s, t)) {
            "segments ${checked.segmentText(s)} and ${checked.segmentText(t)} overlap at (${xy[2 * inner]}, ${xy[2 * inner + 1]})"
        }
    }

    /** An end of one of two overlapping segments that lies on the other: the fault's place. */
    private fun innerEnd(s: Int, t: Int): Int {
        val c = checked.start(t)
        val onS = isBetween(xy[2 * c], xy[2 * checked.start(s)], xy[2 * checked.end(s)]) &&
            isBetween(xy[2 * c + 1], xy[2 * checked.start(s) + 1], xy[2 * checked.end(s) + 1])
        if (onS) return c
        val a = checked.start(s)
        val onT = isBetween(xy[2 * a], xy[2 * c], xy[2 * checked.end(t)]) &&
            isBetween(xy[2 * a + 1], xy[2 * c + 1], xy[2 * checked.end(t) + 1])
        return if (onT) a else checked.end(s)
    }

    private fun silenceTouches(s: Int, t: Int) {
        told.add(key(checked.start(s), t))
        told.add(key(checked.end(s), t))
        told.add(key(checked.start(t), s))
        told.add(key(checked.end(t), s))
    }

    private fun markFaulty(s: Int, t: Int) {
        faultyPairs++
        isFaulty[s] = true
        isFaulty[t] = true
    }

    private fun fourNodes(s: Int, t: Int) =
        intArrayOf(checked.nodeAtStart(s), checked.nodeAtEnd(s), checked.nodeAtStart(t), checked.nodeAtEnd(t))

    private fun coordinate(node: Int) = Coordinate(xy[2 * node], xy[2 * node + 1])

    private companion object {
        /** A domain with so many faults is hopeless; the search ends to spare time. */
        const val PAIR_LIMIT = 1_000_000
    }
}
