package org.trigrid.domain

import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator
import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.Envelope
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.Location
import org.locationtech.jts.index.strtree.STRtree
import org.trigrid.geometry.IntList

/**
 * The domain of undirected segments that meet in nodes only: all that they close off from the outside, less each face with
 * a hole point in it. A segment with the domain on both sides, or on neither, becomes an embedded one; the latter is a
 * fault that [DomainCheck] tells. Nodes of no segment are left out.
 *
 * @param xy x0, y0, x1, y1, …; not modified.
 * @param segments 2 per segment; not modified.
 * @param holes x0, y0, … of points in faces to be left out; not modified.
 */
internal fun Domain.Companion.fromLineWork(
    xy: DoubleArray,
    segments: IntArray,
    segmentTags: IntArray,
    tags: List<String>,
    regionName: String,
    holes: DoubleArray,
): Domain {
    val faces = LineWorkFaces(xy, segments, holes)
    val count = segments.size / 2
    val isBoundary = BooleanArray(count) { faces.isInside(2 * it) != faces.isInside(2 * it + 1) }
    val directed = IntArray(segments.size) { if (faces.isInside(2 * (it / 2))) segments[it] else segments[it xor 1] }
    val noNext = IntArray(count).also { it.fill(-1) }
    val assembly = SegmentAssembly(xy, directed, segmentTags, noNext, BooleanArray(count) { !isBoundary[it] })
    for (s in 0 until count) if (!isBoundary[s]) assembly.embed(segments[2 * s], segments[2 * s + 1], segmentTags[s])
    return assembly.toDomain(tags, regionName)
}

/**
 * The faces of a planar line work. Side 2s is the left of segment s from its start, side 2s + 1 that from its end.
 *
 * Following the sharpest left turn from a side runs round a face; a cycle with a positive area is a face's outer boundary,
 * any other one bounds a connected part of the line work from outside and lies in the smallest face round it.
 */
internal class LineWorkFaces(private val xy: DoubleArray, private val segments: IntArray, holes: DoubleArray) {
    private val sideCount = segments.size
    private val next = IntArray(sideCount)
    private val cycleOf = IntArray(sideCount).also { it.fill(-1) }

    /** Start nodes along each cycle. */
    private val cycles = ArrayList<IntArray>()
    private val signs = IntList()
    private val locators = HashMap<Int, IndexedPointInAreaLocator>()
    private val faceTree = STRtree()
    private val doubleAreas = ArrayList<Double>()

    /** Per cycle: whether the domain lies on its left. */
    private val inside: BooleanArray

    init {
        linkSides()
        for (side in 0 until sideCount) if (cycleOf[side] < 0) traceCycle(side)
        for (c in cycles.indices) if (signs[c] > 0) faceTree.insert(envelope(cycles[c]), c)
        faceTree.build()
        val isHole = BooleanArray(cycles.size)
        for (i in 0 until holes.size / 2) faceAt(holes[2 * i], holes[2 * i + 1], -1)?.let { isHole[it] = true }
        inside = BooleanArray(cycles.size) { c ->
            val face = if (signs[c] > 0) c else faceAround(c)
            face != null && !isHole[face]
        }
    }

    fun isInside(side: Int): Boolean = inside[cycleOf[side]]

    private fun origin(side: Int) = segments[side]

    private fun destination(side: Int) = segments[side xor 1]

    /** Sides around each node by angle; from a side one goes on with the one clockwise next to where one came from. */
    private fun linkSides() {
        val nodeCount = xy.size / 2
        val first = IntArray(nodeCount + 1)
        for (side in 0 until sideCount) first[origin(side) + 1]++
        for (node in 0 until nodeCount) first[node + 1] += first[node]
        val free = first.copyOf()
        val around = IntArray(sideCount)
        for (side in 0 until sideCount) around[free[origin(side)]++] = side
        val directions = Directions(xy)
        for (node in 0 until nodeCount) {
            if (first[node + 1] - first[node] == 2) {
                next[around[first[node]] xor 1] = around[first[node] + 1]
                next[around[first[node] + 1] xor 1] = around[first[node]]
                continue
            }
            val sorted = (first[node] until first[node + 1]).map { around[it] }.sortedWith { a, b ->
                val byAngle = directions.compare(node, destination(a), destination(b))
                if (byAngle != 0) byAngle else a - b
            }
            for (i in sorted.indices) next[sorted[i] xor 1] = sorted[(i + sorted.size - 1) % sorted.size]
        }
    }

    private fun traceCycle(first: Int) {
        val nodes = IntList()
        var side = first
        do {
            cycleOf[side] = cycles.size
            nodes.add(origin(side))
            side = next[side]
        } while (side != first)
        val cycle = nodes.toArray()
        val loop = IntArray(2 * cycle.size) { cycle[(it / 2 + it % 2) % cycle.size] }
        cycles.add(cycle)
        signs.add(SignedArea.sign(xy, loop, 0, cycle.size))
        doubleAreas.add(SignedArea.twice(xy, loop, 0, cycle.size))
    }

    /** The smallest face of another connected part round the cycle [c], or null. Any node of it tells. */
    private fun faceAround(c: Int): Int? {
        val node = cycles[c][0]
        return faceAt(xy[2 * node], xy[2 * node + 1], c)
    }

    /** The smallest face with (x, y) in its interior, or null. Faces with a node of the place have it on their boundary. */
    private fun faceAt(x: Double, y: Double, except: Int): Int? {
        val place = Coordinate(x, y)
        return faceTree.query(Envelope(place)).map { it as Int }.filter { it != except }
            .sortedWith(compareBy<Int> { doubleAreas[it] }.thenBy { it })
            .firstOrNull { locator(it).locate(place) == Location.INTERIOR }
    }

    private fun locator(c: Int) = locators.getOrPut(c) {
        val cycle = cycles[c]
        val ring = Array(cycle.size + 1) { Coordinate(xy[2 * cycle[it % cycle.size]], xy[2 * cycle[it % cycle.size] + 1]) }
        IndexedPointInAreaLocator(FACTORY.createPolygon(ring))
    }

    private fun envelope(cycle: IntArray): Envelope {
        val box = Envelope()
        for (node in cycle) box.expandToInclude(xy[2 * node], xy[2 * node + 1])
        return box
    }

    private companion object {
        val FACTORY = GeometryFactory()
    }
}
