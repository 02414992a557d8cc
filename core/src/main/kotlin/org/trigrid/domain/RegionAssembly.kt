package org.trigrid.domain

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.geometry.IntList

/** The same domain with [region] for its only one. */
internal fun Domain.withBase(region: Region): Domain =
    Domain(xy, segments, segmentTags, embedded, tags, DomainRegions.single(region), points)

/**
 * The same line work with each of its faces told to which region it belongs: that of the marker in it, else that of the
 * smallest outline round it, else the one it had. A hole with a marker in it is filled, and boundary segments with the domain on
 * both sides become embedded ones, so that the loops of two parts that lie side by side part the one from the other.
 *
 * Where lines cross or touch, the result has them and nothing else, for [DomainCheck] to tell. What is wrong with a marker is
 * told there too.
 */
internal fun Domain.withRegions(markers: List<RegionMarker>, outlines: List<RegionOutline> = emptyList()): Domain {
    if (markers.isEmpty() && outlines.isEmpty() && regionMap.isSingle || !regionMap.isPlanar) return this
    val lines = withoutSides(outlines.isNotEmpty())
    return if (DomainCheck.hasLineFaults(lines)) lines else RegionAssembly(this, lines, markers, outlines).assemble()
}

/** The same lines without knowledge of what is inside: all embedded, and of boundary segments between the same nodes the first. */
private fun Domain.withoutSides(inOneDirectionToo: Boolean): Domain {
    val seen = HashSet<Long>(2 * boundaryCount)
    val kept = (0 until segmentCount).filter { s ->
        val a = segmentStart(s)
        val b = segmentEnd(s)
        val isSecond = !isEmbedded(s) && a != b && (pairKey(b, a) in seen || inOneDirectionToo && pairKey(a, b) in seen)
        if (!isEmbedded(s)) seen.add(pairKey(a, b))
        !isSecond
    }
    val single = DomainRegions(java.util.List.of(regions[0]), IntArray(0), emptyList(), isPlanar = false)
    return Domain(
        xy, IntArray(2 * kept.size) { segments[2 * kept[it / 2] + it % 2] }, IntArray(kept.size) { segmentTags[kept[it]] },
        BooleanArray(kept.size) { true }, tags, single, points,
    )
}

private fun pairKey(a: Int, b: Int): Long = (a.toLong() shl 32) or b.toLong()

/** @param lines of [domain], without the second of two that run along each other. */
private class RegionAssembly(
    private val domain: Domain,
    private val lines: Domain,
    private val markers: List<RegionMarker>,
    private val outlines: List<RegionOutline>,
) {
    private val segments = lines.segments
    private val count = lines.segmentCount
    private val faces = LineWorkFaces(lines.xy, segments, DoubleArray(0))
    private val isInside = BooleanArray(faces.faceBound)

    /** Regions that occur, those of the domain first. */
    private val regions = ArrayList(domain.regions)
    private val numbers = HashMap<Region, Int>()

    /** Per face the region. */
    private val regionOf = IntArray(faces.faceBound)

    /** Faces whose neighbours have not been looked at. */
    private val entered = IntList()
    private val markerOf = arrayOfNulls<RegionMarker>(faces.faceBound)
    private val faults = ArrayList<Fault>()

    init {
        // What is said of a region of the domain now holds for all of it.
        val said = (markers.map { it.region } + outlines.map { it.region }).associateBy { it.name }
        for (number in regions.indices) said[regions[number].name]?.let { regions[number] = it }
        for ((number, region) in regions.withIndex()) numbers.putIfAbsent(region, number)
    }

    fun assemble(): Domain {
        enterKnownSides()
        spread()
        if (outlines.isNotEmpty()) {
            val around = RegionOutlines(lines.xy, segments, faces, outlines).smallest()
            for (face in around.indices) if (around[face] >= 0) regionOf[face] = numberOf(outlines[around[face]].region)
        }
        for (marker in markers) place(marker)
        return build()
    }

    /** What lies beside boundary segments, and beside all where the domain has its regions already. */
    private fun enterKnownSides() {
        val regionOfSide = HashMap<Long, Int>(2 * domain.segmentCount)
        for (s in 0 until domain.segmentCount) {
            if (domain.isEmbedded(s) && domain.regionMap.isSingle) continue
            regionOfSide[pairKey(domain.segmentStart(s), domain.segmentEnd(s))] = domain.regionOnLeft(s)
            regionOfSide.putIfAbsent(pairKey(domain.segmentEnd(s), domain.segmentStart(s)), domain.regionOnRight(s))
        }
        for (side in segments.indices) {
            val region = regionOfSide[pairKey(segments[side], segments[side xor 1])] ?: continue
            if (region >= 0) enter(faces.faceOf(side), region)
        }
    }

    private fun enter(face: Int, region: Int) {
        if (face < 0 || isInside[face]) return
        isInside[face] = true
        regionOf[face] = region
        entered.add(face)
    }

    /** Across embedded segments the domain goes on; what they close off is inside too. */
    private fun spread() {
        val boundary = HashSet<Long>(4 * domain.boundaryCount)
        for (s in 0 until domain.boundaryCount) {
            boundary.add(pairKey(domain.segmentStart(s), domain.segmentEnd(s)))
            boundary.add(pairKey(domain.segmentEnd(s), domain.segmentStart(s)))
        }
        val sidesOf = faces.sides()
        while (entered.size > 0) {
            val face = entered.removeLast()
            for (side in sidesOf[face]) {
                if (pairKey(segments[side], segments[side xor 1]) !in boundary) enter(faces.faceOf(side xor 1), regionOf[face])
            }
        }
    }

    private fun place(marker: RegionMarker) {
        val face = faces.faceAt(marker.x, marker.y)
        if (face < 0) {
            val where = if (face == LineWorkFaces.ON_LINE) "lies on a segment" else "lies outside of all loops"
            fault(marker, where)
            return
        }
        val before = markerOf[face]
        if (before == null) {
            markerOf[face] = marker
            isInside[face] = true
            regionOf[face] = numberOf(marker.region)
        } else if (before.region != marker.region) {
            fault(marker, "lies in one part with that of region \"${before.region}\" at (${before.x}, ${before.y})")
        }
    }

    private fun fault(marker: RegionMarker, what: String) {
        val message = "the point of region \"${marker.region}\" at (${marker.x}, ${marker.y}) $what"
        faults.add(Fault(FaultKind.REGION_POINT, message, marker.x, marker.y, IntArray(0)))
    }

    private fun numberOf(region: Region): Int = numbers.getOrPut(region) { regions.size.also { regions.add(region) } }

    private fun build(): Domain {
        val isUsed = BooleanArray(regions.size)
        for (i in segments.indices) region(faces.faceOf(i)).let { if (it >= 0) isUsed[it] = true }
        val newNumber = IntArray(regions.size)
        var used = 0
        for (r in newNumber.indices) newNumber[r] = if (isUsed[r]) used++ else -1
        val list = if (used == 0) domain.regions else regions.filterIndexed { r, _ -> isUsed[r] }

        val left = IntArray(count) { region(faces.faceOf(2 * it)).let { r -> if (r < 0) -1 else newNumber[r] } }
        val right = IntArray(count) { region(faces.faceOf(2 * it + 1)).let { r -> if (r < 0) -1 else newNumber[r] } }
        val isBoundary = BooleanArray(count) { (left[it] < 0) != (right[it] < 0) }
        val directed = IntArray(segments.size) { if (left[it / 2] >= 0) segments[it] else segments[it xor 1] }
        val noNext = IntArray(count).also { it.fill(-1) }
        // In the place of tags the assembly carries numbers of segments along.
        val dropped = BooleanArray(count) { !isBoundary[it] }
        val assembly = SegmentAssembly(lines.xy, directed, IntArray(count) { it }, noNext, dropped)
        for (i in 0 until count) if (!isBoundary[i]) assembly.embed(segments[2 * i], segments[2 * i + 1], i)
        val tagsOf = { given: IntArray -> IntArray(given.size) { lines.segmentTag(given[it]) } }
        return assembly.toDomain(domain.tags, domain.points, tagsOf) { given ->
            val sides = IntArray(2 * given.size) {
                val i = given[it / 2]
                val isTurned = isBoundary[i] && left[i] < 0
                if ((it % 2 == 0) != isTurned) left[i] else right[i]
            }
            DomainRegions(java.util.List.copyOf(list), if (list.size == 1) IntArray(0) else sides, domain.regionMap.faults + faults)
        }
    }

    private fun region(face: Int): Int = if (face >= 0 && isInside[face]) regionOf[face] else -1
}
