package org.trigrid.domain

import org.trigrid.geometry.Point2
import org.trigrid.shape.Line

/**
 * Places nodes on the segments of a domain, as if each were a line shape.
 *
 * For polygons whose points are corners only. The given nodes stay exactly where they are; nodes are numbered anew, along
 * the loops. Segments without length or with a coordinate that is no number stay as they are, for [DomainCheck] to find.
 */
public object EdgeExploder {
    /** As the other, with equal intervals. */
    @JvmStatic
    public fun explode(domain: Domain, spacing: Double): Domain = explode(domain, spacing, 1.0)

    /**
     * @param spacing requested distance of neighbouring nodes, in the domain's unit, > 0; the nearest whole number of
     *   intervals is made, and a segment shorter than that stays whole.
     * @param ratio last interval / first interval of each segment in its direction, > 0, dimensionless.
     * @throws org.trigrid.diagnostics.InvalidShapeException if [spacing] or [ratio] is no number above 0, or asks for
     *   more nodes on a segment than can be.
     */
    @JvmStatic
    public fun explode(domain: Domain, spacing: Double, ratio: Double): Domain {
        val nodes = NodeCollector(domain)
        val segments = IntList()
        val origin = IntList()
        for (segment in 0 until domain.segmentCount) {
            val chain = pieces(domain, segment, spacing, ratio)
            var from = nodes.number(domain.segmentStart(segment))
            for (i in 1 until chain.size / 2) {
                val isLast = i == chain.size / 2 - 1
                val to = if (isLast) nodes.number(domain.segmentEnd(segment)) else nodes.add(chain[2 * i], chain[2 * i + 1])
                segments.add(from)
                segments.add(to)
                origin.add(segment)
                from = to
            }
        }
        for (node in 0 until domain.nodeCount) nodes.number(node)
        val from = origin.toArray()
        return Domain(
            nodes.coordinates(),
            segments.toArray(),
            IntArray(from.size) { domain.segmentTag(from[it]) },
            BooleanArray(from.size) { domain.isEmbedded(from[it]) },
            domain.tags,
            domain.regionName,
        )
    }

    /** The nodes of the exploded segment, ends included. */
    private fun pieces(domain: Domain, segment: Int, spacing: Double, ratio: Double): DoubleArray {
        val a = domain.segmentStart(segment)
        val b = domain.segmentEnd(segment)
        val begin = Point2(domain.x(a), domain.y(a))
        val end = Point2(domain.x(b), domain.y(b))
        val isLine = doubleArrayOf(begin.x, begin.y, end.x, end.y).all { it.isFinite() } && (begin.x != end.x || begin.y != end.y)
        return if (isLine) Line.explode(begin, end, spacing, ratio) else doubleArrayOf(begin.x, begin.y, end.x, end.y)
    }
}

/** Numbers old and new nodes in the order in which the segments meet them. */
private class NodeCollector(private val domain: Domain) {
    private val newNumbers = IntArray(domain.nodeCount) { NONE }
    private var xy = DoubleArray(4 * domain.nodeCount + 2)
    private var count = 0

    /** The number of an old node, given now if it has none. */
    fun number(node: Int): Int {
        if (newNumbers[node] == NONE) newNumbers[node] = add(domain.x(node), domain.y(node))
        return newNumbers[node]
    }

    fun coordinates(): DoubleArray = xy.copyOf(2 * count)

    fun add(x: Double, y: Double): Int {
        if (xy.size < 2 * count + 2) xy = xy.copyOf(2 * xy.size)
        xy[2 * count] = x
        xy[2 * count + 1] = y
        return count++
    }

    private companion object {
        const val NONE = -1
    }
}
