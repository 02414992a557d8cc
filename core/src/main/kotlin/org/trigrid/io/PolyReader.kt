package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.domain.RegionMarker
import org.trigrid.domain.fromLineWork
import org.trigrid.domain.withRegions
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads a `.poly` file of Triangle (Shewchuk 1996), with its points inline or in the `.node` file beside it.
 *
 * As with Triangle, everything that segments close off from the outside is the domain, less the parts with a hole point in
 * them; a segment with the domain on both sides is embedded. A segment's marker m becomes the tag "marker_m", and
 * "boundary" where there is none, or 0. Points that no segment uses are embedded, with the tag "point" or that of their marker.
 * A region of attribute a is called "region_a", and that number is its material; its largest area becomes the largest size,
 * the side of an equilateral element of this area. Attributes of points are left out.
 */
internal class PolyReader private constructor(private val file: Path, text: String) {
    private val lines = PolyLines(file.toString(), text)
    private val tags = LinkedHashMap<String, Int>()

    @Throws(IOException::class)
    private fun read(): NamedDomain {
        val points = readPoints()
        lines.next("the number of segments")
        val segmentCount = lines.count(0, "segments")
        val hasMarkers = lines.fieldCount > 1 && lines.int(1) != 0
        val segments = IntArray(2 * segmentCount)
        val segmentTags = IntArray(segmentCount)
        for (s in 0 until segmentCount) {
            lines.next("segment ${s + 1} of $segmentCount")
            for (end in 0..1) {
                val point = points.indexOf(lines.int(1 + end)) ?: lines.fail(1 + end, "there is no such point")
                segments[2 * s + end] = point
            }
            val marker = if (hasMarkers && lines.fieldCount > 3) lines.int(3) else 0
            segmentTags[s] = tagNumber(if (marker == 0) "boundary" else "marker_$marker")
        }
        val holes = if (lines.hasNext()) readHoles() else DoubleArray(0)
        val regions = if (lines.hasNext()) readRegions() else emptyList()
        val name = DomainFormats.baseName(file)
        val isOnSegment = BooleanArray(points.markers.size)
        for (point in segments) isOnSegment[point] = true
        val pointTags = IntArray(isOnSegment.size) { i ->
            if (isOnSegment[i]) 0 else tagNumber(if (points.markers[i] == 0) "point" else "marker_${points.markers[i]}")
        }
        val domain = Domain.fromLineWork(points.xy, segments, segmentTags, pointTags, tags.keys.toList(), name, holes)
        return NamedDomain(name, domain.withRegions(regions))
    }

    /** Numbers in the file begin with 0 or 1, or run in any order. */
    private class Points(val xy: DoubleArray, val markers: IntArray, private val numbers: Map<Int, Int>) {
        fun indexOf(number: Int): Int? = numbers[number]
    }

    private fun readPoints(): Points {
        lines.next("the number of points")
        if (lines.count(0, "points") > 0) return readPoints(lines)
        val nodeFile = file.resolveSibling(file.fileName.toString().removeSuffix(".poly") + ".node")
        if (!Files.exists(nodeFile)) lines.fail(0, "there are no points here, and no file ${nodeFile.fileName} beside it")
        val nodeLines = PolyLines(nodeFile.toString(), DomainFormats.textOf(nodeFile))
        nodeLines.next("the number of points")
        return readPoints(nodeLines)
    }

    private fun readPoints(from: PolyLines): Points {
        val count = from.count(0, "points")
        if (from.fieldCount > 1 && from.int(1) != 2) from.fail(1, "points must have two coordinates")
        val xy = DoubleArray(2 * count)
        val markers = IntArray(count)
        val attributes = if (from.fieldCount > 2) from.int(2) else 0
        val hasMarkers = from.fieldCount > 3 && from.int(3) != 0
        val numbers = HashMap<Int, Int>(2 * count)
        for (i in 0 until count) {
            from.next("point ${i + 1} of $count")
            if (numbers.put(from.int(0), i) != null) from.fail(0, "there is a point of that number already")
            xy[2 * i] = from.double(1)
            xy[2 * i + 1] = from.double(2)
            val field = 3 + attributes
            if (hasMarkers && from.fieldCount > field) markers[i] = from.int(field)
        }
        return Points(xy, markers, numbers)
    }

    private fun readHoles(): DoubleArray {
        lines.next("the number of holes")
        val count = lines.count(0, "holes")
        val holes = DoubleArray(2 * count)
        for (i in 0 until count) {
            lines.next("hole ${i + 1} of $count")
            holes[2 * i] = lines.double(1)
            holes[2 * i + 1] = lines.double(2)
        }
        return holes
    }

    private fun readRegions(): List<RegionMarker> {
        lines.next("the number of regions")
        val count = lines.count(0, "regions")
        val known = LinkedHashMap<String, Region>()
        return List(count) { i ->
            lines.next("region ${i + 1} of $count")
            val attribute = if (lines.fieldCount > 3) lines.double(3) else 0.0
            val area = if (lines.fieldCount > 4) lines.double(4) else 0.0
            RegionMarker(lines.double(1), lines.double(2), region(attribute, area, known))
        }
    }

    private fun region(attribute: Double, area: Double, known: MutableMap<String, Region>): Region {
        val isNumber = attribute >= 1 && attribute <= Int.MAX_VALUE && attribute == Math.rint(attribute)
        val base = "region_" + if (attribute == Math.rint(attribute)) attribute.toLong().toString() else attribute.toString()
        val size = if (area > 0) Math.sqrt(area / PolyFormat.AREA_OF_SQUARE) else Double.POSITIVE_INFINITY
        var name = base
        var n = 2
        while (true) {
            val region = Region.of(name).withMaterial(if (isNumber) attribute.toInt() else 0).withMaxSize(size)
            val before = known.putIfAbsent(name, region)
            if (before == null || before == region) return region
            name = "${base}_${n++}"
        }
    }

    private fun tagNumber(tag: String): Int = tags.getOrPut(tag) { tags.size }

    companion object {
        /** @throws FileFormatException with line and column of what is wrong. */
        @Throws(IOException::class)
        fun read(file: Path, text: String): List<NamedDomain> = listOf(PolyReader(file, text).read())
    }
}
