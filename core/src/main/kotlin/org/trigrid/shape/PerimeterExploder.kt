package org.trigrid.shape

import org.trigrid.geometry.Point2
import java.util.Arrays

/** Explodes a closed polygon whose ratio runs once round the perimeter, with a node at every vertex. */
internal object PerimeterExploder {
    fun explode(vertices: List<Point2>, traits: Traits): DoubleArray {
        val growth = TrackExploder.growth(traits)
        if (growth == 1.0) return SideExploder.explode(vertices + vertices.first(), traits)
        val symmetric = traits.distribution == Distribution.SYMMETRIC
        val forward = if (symmetric) isCanonical(vertices) else traits.ratio > 1
        val travelled = if (forward) vertices else Polygon.turned(vertices)
        val xy = Perimeter(travelled + travelled.first(), traits, growth).explode()
        return if (forward) xy else xy.also(TrackExploder::reverse)
    }

    private fun isCanonical(vertices: List<Point2>): Boolean {
        val next = vertices[1]
        val previous = vertices.last()
        return next.x < previous.x || next.x == previous.x && next.y < previous.y
    }
}

/** @param corners the vertices in the order of travel, the first one again at the end. */
private class Perimeter(private val corners: List<Point2>, private val traits: Traits, growth: Double) {
    /** Per corner: length of the way to it. */
    private val way = DoubleArray(corners.size)

    /** Where the whole perimeter's nodes would lie if it had no corners; parts of it. */
    private val cuts: DoubleArray

    init {
        for (j in 1 until corners.size) {
            val a = corners[j - 1]
            val b = corners[j]
            way[j] = way[j - 1] + StrictMath.hypot(b.x - a.x, b.y - a.y)
        }
        val length = way.last()
        cuts = Intervals.fractions(Intervals.count(length, traits, growth), growth, traits.distribution)
        for (j in way.indices) way[j] /= length
    }

    fun explode(): DoubleArray = SideExploder.join(List(corners.size - 1) { side(it) })

    private fun side(j: Int): DoubleArray {
        val from = intervalsBefore(way[j])
        val to = intervalsBefore(way[j + 1])
        val wanted = to - from
        val count = Math.max(1, if (traits.rounding == Rounding.CEILING) ceiling(wanted) else Math.round(wanted).toInt())
        val a = corners[j]
        val b = corners[j + 1]
        val xy = DoubleArray(2 * count + 2)
        for (i in 0 until count) {
            val part = (wayAfter(from + i * wanted / count) - way[j]) / (way[j + 1] - way[j])
            xy[2 * i] = if (i == 0) a.x else a.x + part * (b.x - a.x)
            xy[2 * i + 1] = if (i == 0) a.y else a.y + part * (b.y - a.y)
        }
        xy[2 * count] = b.x
        xy[2 * count + 1] = b.y
        return xy
    }

    /** Rounded up, but not for the sake of a rounding error. */
    private fun ceiling(wanted: Double): Int = Math.ceil(wanted - 1e-9).toInt()

    /** How many intervals, a part of one included, lie before the part [fraction] of the perimeter. */
    private fun intervalsBefore(fraction: Double): Double {
        val found = Arrays.binarySearch(cuts, fraction)
        if (found >= 0) return found.toDouble()
        val k = Math.min(Math.max(-found - 2, 0), cuts.size - 2)
        return k + (fraction - cuts[k]) / (cuts[k + 1] - cuts[k])
    }

    /** The inverse of [intervalsBefore]. */
    private fun wayAfter(intervals: Double): Double {
        val k = Math.min(intervals.toInt(), cuts.size - 2)
        return cuts[k] + (intervals - k) * (cuts[k + 1] - cuts[k])
    }
}
