package org.trigrid.domain

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Traits

/** Explodes each segment of a domain as a line of its own; see [Domain.respaced]. */
internal class Respacing(private val domain: Domain, spacing: Double, ratio: Double) {
    private val traits = Traits("segment", spacing, ratio)
    private val lines = Array(domain.segmentCount) { explode(it) }

    fun respaced(): Domain {
        val total = lines.sumOf { intervals(it).toLong() }
        if (total > MOST_SEGMENTS) throw InvalidShapeException("spacing ${traits.spacing} would make $total segments")
        val added = total.toInt() - domain.segmentCount
        val coordinates = domain.xy.copyOf(2 * (domain.nodeCount + added))
        domain.xy.copyInto(coordinates, 2 * (domain.segmentNodeCount + added), 2 * domain.segmentNodeCount)
        val segments = IntArray(2 * total.toInt())
        val tags = IntArray(total.toInt())
        val embedded = BooleanArray(total.toInt())
        val origin = IntArray(total.toInt())
        var node = domain.segmentNodeCount
        var made = 0
        for ((s, line) in lines.withIndex()) {
            val inner = 2 * (intervals(line) - 1)
            line.copyInto(coordinates, 2 * node, 2, 2 + inner)
            var from = domain.segmentStart(s)
            for (k in 1..intervals(line)) {
                val to = if (k == intervals(line)) domain.segmentEnd(s) else node++
                segments[2 * made] = from
                segments[2 * made + 1] = to
                tags[made] = domain.segmentTag(s)
                origin[made] = s
                embedded[made++] = domain.isEmbedded(s)
                from = to
            }
        }
        val points = domain.points.nodes.map { if (it < domain.segmentNodeCount) it else it + added }
        return Domain(
            coordinates, segments, tags, embedded, domain.tags, domain.regionMap.ofParts(origin),
            DomainPoints(points.toIntArray(), domain.points.tags),
        )
    }

    private fun intervals(line: DoubleArray): Int = line.size / 2 - 1

    /** Nodes x0, y0, … of segment [s], ends included. A faulty segment stays as it is, for the domain's check to tell. */
    private fun explode(s: Int): DoubleArray {
        val begin = Point2(domain.x(domain.segmentStart(s)), domain.y(domain.segmentStart(s)))
        val end = Point2(domain.x(domain.segmentEnd(s)), domain.y(domain.segmentEnd(s)))
        val length = begin.distanceTo(end)
        if (length == 0.0 || !length.isFinite()) return doubleArrayOf(begin.x, begin.y, end.x, end.y)
        return Line.explode(begin, end, traits)
    }

    private companion object {
        const val MOST_SEGMENTS = 100_000_000
    }
}
