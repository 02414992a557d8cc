package org.trigrid.domain

import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator
import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.Envelope
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.Location
import org.locationtech.jts.index.strtree.STRtree

/**
 * Which loop contains which, for loops that do not cross: O(n log n) by a tree of their boxes and an index of segments
 * in each loop that may contain another. Loops may touch.
 */
internal class LoopNesting(
    private val xy: DoubleArray,
    /** Node numbers of each loop. Not modified. */
    private val loops: List<IntArray>,
) {
    private val doubleAreas = DoubleArray(loops.size)
    private val areaSigns = IntArray(loops.size)
    private val envelopes = loops.map { envelope(it) }
    private val locators = arrayOfNulls<IndexedPointInAreaLocator>(loops.size)
    private val parent = IntArray(loops.size).also { it.fill(-1) }
    private val largestFirst: List<Int>

    init {
        for ((i, loop) in loops.withIndex()) {
            val segments = IntArray(2 * loop.size) { loop[(it / 2 + it % 2) % loop.size] }
            doubleAreas[i] = Math.abs(SignedArea.twice(xy, segments, 0, loop.size))
            areaSigns[i] = SignedArea.sign(xy, segments, 0, loop.size)
        }
        largestFirst = loops.indices.sortedWith(compareByDescending<Int> { doubleAreas[it] }.thenBy { it })
        if (loops.size > 1) findParents()
    }

    /** 1 if the loop runs anticlockwise, -1 if clockwise, 0 if it has no area. */
    fun areaSign(loop: Int): Int = areaSigns[loop]

    /** The smallest loop that contains [loop], or -1. */
    fun parentOf(loop: Int): Int = parent[loop]

    fun parents(): IntArray = parent.copyOf()

    /** Loops by falling area: each comes after the one that contains it. */
    fun fromLargest(): List<Int> = largestFirst

    private fun findParents() {
        val rank = IntArray(loops.size)
        for ((position, loop) in largestFirst.withIndex()) rank[loop] = position
        val tree = STRtree()
        for (i in loops.indices) if (!envelopes[i].isNull && loops[i].size > 2) tree.insert(envelopes[i], i)
        for (i in loops.indices) {
            if (envelopes[i].isNull) continue
            val candidates = tree.query(envelopes[i]).map { it as Int }
                .filter { rank[it] < rank[i] && envelopes[it].contains(envelopes[i]) }
            parent[i] = candidates.sortedByDescending { rank[it] }.firstOrNull { contains(it, i) } ?: -1
        }
    }

    /** Decided by the first node, or else the first segment's middle, that is not on the outer loop itself. */
    private fun contains(outer: Int, inner: Int): Boolean {
        val locator = locators[outer] ?: IndexedPointInAreaLocator(polygon(loops[outer])).also { locators[outer] = it }
        val nodes = loops[inner]
        for (node in nodes) {
            val location = locator.locate(Coordinate(xy[2 * node], xy[2 * node + 1]))
            if (location != Location.BOUNDARY) return location == Location.INTERIOR
        }
        for (i in nodes.indices) {
            val location = locator.locate(middle(nodes[i], nodes[(i + 1) % nodes.size]))
            if (location != Location.BOUNDARY) return location == Location.INTERIOR
        }
        return false
    }

    private fun middle(a: Int, b: Int) =
        Coordinate(xy[2 * a] / 2 + xy[2 * b] / 2, xy[2 * a + 1] / 2 + xy[2 * b + 1] / 2)

    private fun polygon(loop: IntArray) = FACTORY.createPolygon(
        Array(loop.size + 1) { Coordinate(xy[2 * loop[it % loop.size]], xy[2 * loop[it % loop.size] + 1]) },
    )

    /** Null, so that it meets no other, where a coordinate is not finite. */
    private fun envelope(loop: IntArray): Envelope {
        val box = Envelope()
        for (node in loop) {
            if (!xy[2 * node].isFinite() || !xy[2 * node + 1].isFinite()) return Envelope()
            box.expandToInclude(xy[2 * node], xy[2 * node + 1])
        }
        return box
    }

    private companion object {
        val FACTORY = GeometryFactory()
    }
}
