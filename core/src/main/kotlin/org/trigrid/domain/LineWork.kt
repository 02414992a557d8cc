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
 * fault that [DomainCheck] tells. Nodes of no segment that lie in the domain become embedded points, others are left out.
 *
 * @param xy x0, y0, x1, y1, …; not modified.
 * @param segments 2 per segment; not modified.
 * @param holes x0, y0, … of points in faces to be left out; not modified.
 * @param pointTags per node: index into [tags] of its group should it be a point; not modified.
 */
internal fun Domain.Companion.fromLineWork(
    xy: DoubleArray,
    segments: IntArray,
    segmentTags: IntArray,
    pointTags: IntArray,
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
    val points = lonePoints(xy, segments, faces)
    val tagged = DomainPoints(points, IntArray(points.size) { pointTags[points[it]] })
    return assembly.toDomain(tags, tagged, { it }) { DomainRegions.single(Region.of(regionName)) }
}

private fun lonePoints(xy: DoubleArray, segments: IntArray, faces: LineWorkFaces): IntArray {
    val isOnSegment = BooleanArray(xy.size / 2)
    for (node in segments) isOnSegment[node] = true
    return isOnSegment.indices.filter { !isOnSegment[it] && faces.isMeshed(faces.faceAt(xy[2 * it], xy[2 * it + 1])) }.toIntArray()
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

    /** Per cycle: the cycle that bounds the face on its left from outside, or [OUTSIDE]. */
    private val faceOfCycle: IntArray

    /** Per cycle that bounds a face from outside: whether a hole point lies in the face. */
    private val isHole: BooleanArray

    init {
        linkSides()
        for (side in 0 until sideCount) if (cycleOf[side] < 0) traceCycle(side)
        for (c in cycles.indices) if (signs[c] > 0) faceTree.insert(envelope(cycles[c]), c)
        faceTree.build()
        isHole = BooleanArray(cycles.size)
        for (i in 0 until holes.size / 2) {
            val face = faceAt(holes[2 * i], holes[2 * i + 1], -1)
            if (face >= 0) isHole[face] = true
        }
        faceOfCycle = IntArray(cycles.size) { c -> if (signs[c] > 0) c else faceAround(c) }
    }

    /** Numbers of faces are below this. */
    val faceBound: Int get() = cycles.size

    /** Per face the start nodes along its boundaries: the outer one, then those of what lies in it and has an area. Not modified. */
    fun boundaries(): Array<List<IntArray>> {
        val within = cycles.indices.filter { signs[it] < 0 && faceOfCycle[it] >= 0 }.groupBy { faceOfCycle[it] }
        return Array(faceBound) { face -> listOf(cycles[face]) + within[face].orEmpty().map { cycles[it] } }
    }

    /** Per face the sides that have it on their left; those of the outside come last, at [faceBound]. */
    fun sides(): Array<IntArray> {
        val lists = Array(faceBound + 1) { IntList() }
        for (side in 0 until sideCount) lists[if (faceOf(side) >= 0) faceOf(side) else faceBound].add(side)
        return Array(lists.size) { lists[it].toArray() }
    }

    /** The face on the left of a side, or [OUTSIDE]. */
    fun faceOf(side: Int): Int = faceOfCycle[cycleOf[side]]

    /** Whether the face on the left of a side is closed off from the outside and no hole point lies in it. */
    fun isInside(side: Int): Boolean = isMeshed(faceOf(side))

    /** Whether it is a face, and none with a hole point in it. */
    fun isMeshed(face: Int): Boolean = face >= 0 && !isHole[face]

    /** The face with (x, y) in its interior, [OUTSIDE], or [ON_LINE] where the place lies on the boundary of a face. */
    fun faceAt(x: Double, y: Double): Int = faceAt(x, y, -1)

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

    /** The smallest face of another connected part round the cycle [c], or [OUTSIDE]. Any node of it tells. */
    private fun faceAround(c: Int): Int {
        val node = cycles[c][0]
        val place = Coordinate(xy[2 * node], xy[2 * node + 1])
        return facesNear(place, c).firstOrNull { locator(it).locate(place) == Location.INTERIOR } ?: OUTSIDE
    }

    private fun faceAt(x: Double, y: Double, except: Int): Int {
        val place = Coordinate(x, y)
        for (face in facesNear(place, except)) {
            when (locator(face).locate(place)) {
                Location.INTERIOR -> return face
                Location.BOUNDARY -> return ON_LINE
            }
        }
        return OUTSIDE
    }

    /** Faces whose boxes hold the place, the smallest first. */
    private fun facesNear(place: Coordinate, except: Int): List<Int> =
        faceTree.query(Envelope(place)).map { it as Int }.filter { it != except }
            .sortedWith(compareBy<Int> { doubleAreas[it] }.thenBy { it })

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

    companion object {
        const val OUTSIDE = -1
        const val ON_LINE = -2
        private val FACTORY = GeometryFactory()
    }
}
