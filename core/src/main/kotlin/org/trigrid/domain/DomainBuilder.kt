package org.trigrid.domain

import java.util.Collections
import org.trigrid.geometry.IntList

/**
 * Collects loops and embedded lines and makes a [Domain] of them.
 *
 * Loops come in any order and either direction; each is turned so that the domain lies on its left. Islands in holes
 * and several separate outer loops are allowed. Points at the same place, in one loop or in several, become one node;
 * no other repair is made, and [DomainCheck] tells what is wrong with the result. A loop that passes through a node
 * twice is split there.
 *
 * Coordinates: x0, y0, x1, y1, …; a loop's first point is not repeated at its end. Arrays are not modified, nor kept.
 */
public class DomainBuilder internal constructor() {
    private val places = PlaceIndex(64)
    private val tags = LinkedHashMap<String, Int>()
    private val loops = ArrayList<LoopDraft>()
    private val embeddedLines = ArrayList<LoopDraft>()
    private val pointNodes = IntList()
    private val pointTags = IntList()
    private val markers = ArrayList<RegionMarker>()
    private val outlines = ArrayList<RegionOutline>()

    /** By name, of markers and outlines. */
    private val regions = HashMap<String, Region>()
    private var base = Region.of(Region.DEFAULT_NAME)

    /** Adds an outer boundary with the tag "boundary". */
    public fun outer(xy: DoubleArray): DomainBuilder = outer(xy, DEFAULT_TAG)

    /**
     * Adds an outer boundary, whatever its direction.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values or none.
     */
    public fun outer(xy: DoubleArray, tag: String): DomainBuilder = add(xy, sameTags(xy, tag), LoopRole.OUTER)

    /** As [outer] with a tag for each segment, that of segment i from point i to the next. */
    public fun outer(xy: DoubleArray, segmentTags: List<String>): DomainBuilder = add(xy, segmentTags, LoopRole.OUTER)

    /** Adds a hole with the tag "boundary". */
    public fun hole(xy: DoubleArray): DomainBuilder = hole(xy, DEFAULT_TAG)

    /**
     * Adds a hole, whatever its direction.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values or none.
     */
    public fun hole(xy: DoubleArray, tag: String): DomainBuilder = add(xy, sameTags(xy, tag), LoopRole.HOLE)

    /** As [hole] with a tag for each segment, that of segment i from point i to the next. */
    public fun hole(xy: DoubleArray, segmentTags: List<String>): DomainBuilder = add(xy, segmentTags, LoopRole.HOLE)

    /** Adds a loop whose role is found out, with the tag "boundary". */
    public fun loop(xy: DoubleArray): DomainBuilder = loop(xy, DEFAULT_TAG)

    /**
     * Adds a loop whose role is found out: inside an outer loop it is a hole, inside a hole or nothing an outer loop.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values or none.
     */
    public fun loop(xy: DoubleArray, tag: String): DomainBuilder = add(xy, sameTags(xy, tag), null)

    /** As [loop] with a tag for each segment, that of segment i from point i to the next. */
    public fun loop(xy: DoubleArray, segmentTags: List<String>): DomainBuilder = add(xy, segmentTags, null)

    /**
     * Adds an open line inside the domain whose points become nodes and whose segments become edges of the mesh.
     * It may begin, end or bend on boundary nodes.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values, or fewer than two points.
     */
    public fun embed(xy: DoubleArray, tag: String): DomainBuilder = apply {
        requirePairs(xy)
        require(xy.size >= 4) { "an embedded line needs two points or more" }
        embeddedLines.add(LoopDraft(nodes(xy), IntArray(xy.size / 2 - 1) { tagNumber(tag) }, null))
    }

    /**
     * Adds a closed line inside the domain whose points become nodes and whose segments become edges of the mesh; as it parts
     * what is inside of it from what is outside, it may be the interface of two regions.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values, or fewer than three points.
     */
    public fun embedLoop(xy: DoubleArray, tag: String): DomainBuilder = apply {
        requirePairs(xy)
        require(xy.size >= 6) { "an embedded loop needs three points or more" }
        val nodes = nodes(xy)
        embeddedLines.add(LoopDraft(nodes + nodes[0], IntArray(xy.size / 2) { tagNumber(tag) }, null))
    }

    /**
     * Adds a point inside the domain that becomes a node of the mesh. One that is a node already, on the boundary or a line, stays
     * that node. Domain and mesh know it by its [tag].
     */
    public fun embedPoint(x: Double, y: Double, tag: String): DomainBuilder = apply {
        pointNodes.add(places.numberOf(x, y))
        pointTags.add(tagNumber(tag))
    }

    /** Names the region of all parts of the domain that no other is given for. Default "domain". */
    public fun regionName(value: String): DomainBuilder = baseRegion(Region.of(value))

    /** Sets the region of all parts of the domain that no other is given for. */
    public fun baseRegion(region: Region): DomainBuilder = apply { base = region }

    /**
     * Gives the part of the domain round a place to a region: all that can be reached from there without crossing a segment.
     * Several parts may be given to the same region. A hole that the place lies in is filled: its loop becomes an interface.
     * A place on a segment, outside of all loops, or in one part with that of another region is a fault.
     *
     * @throws IllegalArgumentException if another region has the same name.
     */
    public fun region(x: Double, y: Double, region: Region): DomainBuilder = apply {
        requireNew(region)
        regions[region.name] = region
        markers.add(RegionMarker(x, y, region))
    }

    /** Adds the outline of a part of the domain that belongs to a region, with the tag "boundary". */
    public fun region(xy: DoubleArray, region: Region): DomainBuilder = region(xy, region, DEFAULT_TAG)

    /**
     * Adds the outline of a part of the domain that belongs to a region, whatever its direction. Segments that it shares with
     * other outlines or loops are taken once, with the tag that came first, and become interfaces where different regions meet.
     * Within an outline there may be holes and other outlines; the smallest one round a place says its region.
     *
     * @throws IllegalArgumentException if [xy] has an odd number of values or none, or another region has the same name.
     */
    public fun region(xy: DoubleArray, region: Region, tag: String): DomainBuilder = region(xy, region, sameTags(xy, tag))

    /** As the other with a tag for each segment, that of segment i from point i to the next. */
    public fun region(xy: DoubleArray, region: Region, segmentTags: List<String>): DomainBuilder = apply {
        requireNew(region)
        outer(xy, segmentTags)
        regions[region.name] = region
        outlines.add(RegionOutline(xy.copyOf(), region))
    }

    /**
     * Adds the loops, lines and points of another domain, its parts as regions; sides that it shares with what was added before
     * are taken once.
     *
     * @throws IllegalArgumentException if another region has the name of one of its regions.
     */
    public fun add(domain: Domain): DomainBuilder = apply {
        for (loop in 0 until domain.loopCount) {
            val segments = domain.loopStart(loop) until domain.loopStart(loop + 1)
            val nodes = domain.loopNodes(loop)
            val xy = DoubleArray(2 * nodes.size) { domain.xy[2 * nodes[it / 2] + it % 2] }
            val names = segments.map { domain.tags[domain.segmentTag(it)] }
            if (domain.isHole(loop)) hole(xy, names) else region(xy, domain.regions[domain.regionOnLeft(segments.first)], names)
        }
        for (s in domain.boundaryCount until domain.segmentCount) {
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            embed(doubleArrayOf(domain.x(a), domain.y(a), domain.x(b), domain.y(b)), domain.tags[domain.segmentTag(s)])
        }
        for (p in 0 until domain.pointCount) {
            embedPoint(domain.x(domain.pointNode(p)), domain.y(domain.pointNode(p)), domain.tags[domain.pointTag(p)])
        }
        if (domain.regions.size > 1) for (marker in RegionPoints.of(domain)) region(marker.x, marker.y, marker.region)
    }

    /** The domain; [assemble] also tells which loops were turned. The builder may go on and build again. */
    public fun build(): Domain = assemble().domain

    /** The domain, and what became of each loop added. */
    public fun assemble(): DomainAssembly {
        val xy = places.toArray()
        val nesting = LoopNesting(xy, loops.map { it.nodes })
        val roles = resolveRoles(nesting)
        val reversed = BooleanArray(loops.size) {
            nesting.areaSign(it) == if (roles[it] == LoopRole.OUTER) -1 else 1
        }
        val directed = loops.mapIndexed { i, loop -> if (reversed[i]) loop.reversed() else loop }
        val steps = WalkSteps(xy.size / 2, directed.map { it.nodes }, directed.map { it.segmentTags })
        val assembly = SegmentAssembly(xy, steps.segments, steps.tags, steps.next, BooleanArray(steps.count))
        for (line in embeddedLines) {
            for (i in line.segmentTags.indices) assembly.embed(line.nodes[i], line.nodes[i + 1], line.segmentTags[i])
        }
        val points = DomainPoints(pointNodes.toArray(), pointTags.toArray())
        val domain = assembly.toDomain(tags.keys.toList(), points, { it }) { DomainRegions.single(base) }
        return DomainAssembly(domain.withRegions(markers, outlines), roles, reversed, nesting.parents())
    }

    /** Parents are larger than what they contain, so that their roles are known first. */
    private fun resolveRoles(nesting: LoopNesting): List<LoopRole> {
        val roles = arrayOfNulls<LoopRole>(loops.size)
        for (i in nesting.fromLargest()) {
            val parent = nesting.parentOf(i)
            val found = if (parent >= 0 && roles[parent] == LoopRole.OUTER) LoopRole.HOLE else LoopRole.OUTER
            roles[i] = loops[i].role ?: found
        }
        return roles.map { it!! }
    }

    private fun add(xy: DoubleArray, segmentTags: List<String>, role: LoopRole?): DomainBuilder = apply {
        requirePairs(xy)
        require(xy.isNotEmpty()) { "a loop needs points" }
        require(segmentTags.size == xy.size / 2) { "${xy.size / 2} segments have ${segmentTags.size} tags" }
        loops.add(LoopDraft(nodes(xy), IntArray(segmentTags.size) { tagNumber(segmentTags[it]) }, role))
    }

    /** Regions are told apart by their names. */
    private fun requireNew(region: Region) {
        val known = regions[region.name]
        require(known == null || known == region) { "there is another region called \"${region.name}\"" }
    }

    private fun requirePairs(xy: DoubleArray) =
        require(xy.size % 2 == 0) { "coordinates come in pairs, but there are ${xy.size} values" }

    private fun nodes(xy: DoubleArray) = IntArray(xy.size / 2) { places.numberOf(xy[2 * it], xy[2 * it + 1]) }

    private fun tagNumber(tag: String): Int = tags.getOrPut(tag) { tags.size }

    private fun sameTags(xy: DoubleArray, tag: String): List<String> = Collections.nCopies(xy.size / 2, tag)

    private companion object {
        const val DEFAULT_TAG = "boundary"
    }
}

/** A loop, or an open line, as it was added. */
private class LoopDraft(val nodes: IntArray, val segmentTags: IntArray, val role: LoopRole?) {
    /** The same loop the other way round, from the same node; each segment keeps its tag. */
    fun reversed(): LoopDraft {
        val n = nodes.size
        return LoopDraft(IntArray(n) { nodes[(n - it) % n] }, segmentTags.reversedArray(), role)
    }
}
