package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.domain.Domain
import org.trigrid.domain.fromLineWork
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads a `.poly` file of Triangle (Shewchuk 1996), with its points inline or in the `.node` file beside it.
 *
 * As with Triangle, everything that segments close off from the outside is the domain, less the parts with a hole point in
 * them; a segment with the domain on both sides is embedded. A segment's marker m becomes the tag "marker_m", and
 * "boundary" where there is none, or 0. Points that no segment uses, attributes and regions are left out.
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
        val name = DomainFormats.baseName(file)
        return NamedDomain(name, Domain.fromLineWork(points.xy, segments, segmentTags, tags.keys.toList(), name, holes))
    }

    /** Numbers in the file begin with 0 or 1, or run in any order. */
    private class Points(val xy: DoubleArray, private val numbers: Map<Int, Int>) {
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
        val numbers = HashMap<Int, Int>(2 * count)
        for (i in 0 until count) {
            from.next("point ${i + 1} of $count")
            if (numbers.put(from.int(0), i) != null) from.fail(0, "there is a point of that number already")
            xy[2 * i] = from.double(1)
            xy[2 * i + 1] = from.double(2)
        }
        return Points(xy, numbers)
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

    private fun tagNumber(tag: String): Int = tags.getOrPut(tag) { tags.size }

    companion object {
        /** @throws FileFormatException with line and column of what is wrong. */
        @Throws(IOException::class)
        fun read(file: Path, text: String): List<NamedDomain> = listOf(PolyReader(file, text).read())
    }
}
