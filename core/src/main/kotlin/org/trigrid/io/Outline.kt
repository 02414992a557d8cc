package org.trigrid.io

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.shape.ArcLength
import org.trigrid.shape.Distribution
import org.trigrid.shape.Intervals
import org.trigrid.shape.Speed
import org.trigrid.shape.Track
import org.trigrid.shape.TrackExploder
import org.trigrid.shape.Traits

/**
 * A curve of a drawing with the tag of its segments, and how it is to be divided where the drawing says so.
 *
 * @param nodes x0, y0, … where it is divided already, the same from both sides.
 */
internal class OutlinePiece(val curve: PlaneCurve, val tag: String, val division: OutlineDivision? = null, val nodes: DoubleArray? = null) {
    fun reversed(): OutlinePiece = OutlinePiece(
        if (curve is StraightLine) StraightLine(curve.endX, curve.endY, curve.beginX, curve.beginY) else ReversedCurve(curve),
        tag, division?.reversed(), nodes?.let { DoubleArray(it.size) { i -> nodes[it.size - 2 - i + 2 * (i % 2)] } },
    )
}

/** @param ratio last interval / first interval, in geometric progression. */
internal class OutlineDivision(val count: Int, val ratio: Double) {
    fun reversed(): OutlineDivision = OutlineDivision(count, 1 / ratio)
}

/** A curve travelled the other way. */
private class ReversedCurve(private val curve: PlaneCurve) : PlaneCurve {
    override val knots: DoubleArray = DoubleArray(curve.knots.size) { -curve.knots[curve.knots.size - 1 - it] }

    override fun x(u: Double) = curve.x(-u)

    override fun y(u: Double) = curve.y(-u)

    override fun speed(u: Double) = curve.speed(-u)

    override val beginX: Double get() = curve.endX
    override val beginY: Double get() = curve.endY
    override val endX: Double get() = curve.beginX
    override val endY: Double get() = curve.beginY
}

/** The loops and open lines of a drawing, on their way to a domain. */
internal class Outline(private val input: DomainText, region: Region) {
    private val builder = Domain.builder().baseRegion(region)
    private var loops = 0

    constructor(input: DomainText, regionName: String) : this(input, Region.of(regionName))

    val isEmpty: Boolean get() = loops == 0

    /** Adds a loop, each piece beginning where the one before ends; a gap at the end is closed by a line. Its role is found out. */
    fun loop(pieces: List<OutlinePiece>) = add(pieces) { xy, tags -> builder.loop(xy, tags) }

    fun outer(pieces: List<OutlinePiece>) = add(pieces) { xy, tags -> builder.outer(xy, tags) }

    fun hole(pieces: List<OutlinePiece>) = add(pieces) { xy, tags -> builder.hole(xy, tags) }

    private fun add(pieces: List<OutlinePiece>, take: (DoubleArray, List<String>) -> Unit) {
        val points = Points()
        for (piece in pieces) points.add(nodesOf(piece, pieces.size == 1), piece.tag)
        if (points.count == 0) return
        if (!points.isClosed()) {
            val closing = StraightLine(points.lastX, points.lastY, points.firstX, points.firstY)
            points.add(PieceDivision.points(OutlinePiece(closing, pieces.last().tag), input.spacing, input.ratio, false), pieces.last().tag)
        }
        val (xy, tags) = points.ring()
        if (tags.isEmpty()) return
        take(xy, tags)
        loops++
    }

    /** Adds a line that is kept inside of the domain. */
    fun embed(pieces: List<OutlinePiece>) {
        for (piece in pieces) {
            val xy = nodesOf(piece, false)
            if (xy.size >= 4) builder.embed(xy, piece.tag)
        }
    }

    /** Adds a point that is kept inside of the domain. */
    fun embedPoint(x: Double, y: Double, tag: String) {
        builder.embedPoint(x, y, tag)
    }

    private fun nodesOf(piece: OutlinePiece, isAlone: Boolean): DoubleArray =
        piece.nodes ?: PieceDivision.points(piece, input.spacing, input.ratio, isAlone)

    fun toDomain(): Domain = builder.build()

    /** Points with the tag of the segment to the next. */
    private class Points {
        private var xy = DoubleArray(64)
        private val tags = ArrayList<String>()
        var count = 0
            private set

        val firstX get() = xy[0]
        val firstY get() = xy[1]
        val lastX get() = xy[2 * count - 2]
        val lastY get() = xy[2 * count - 1]

        fun add(points: DoubleArray, tag: String) {
            for (i in 0 until points.size / 2) {
                // Where a piece begins its predecessor ended; nodes at one place are one.
                if (count > 0 && (i == 0 || points[2 * i] == lastX && points[2 * i + 1] == lastY)) continue
                if (2 * count + 2 > xy.size) xy = xy.copyOf(4 * count)
                xy[2 * count] = points[2 * i]
                xy[2 * count + 1] = points[2 * i + 1]
                if (count > 0) tags.add(tag)
                count++
            }
        }

        fun isClosed() = count > 1 && firstX == lastX && firstY == lastY

        fun ring(): Pair<DoubleArray, List<String>> = Pair(xy.copyOf(2 * (count - 1)), tags)
    }
}

/** Divides pieces into nodes. */
internal object PieceDivision {
    private const val LARGEST_BEND = Math.PI / 18
    private const val SAMPLES = 24
    private const val MOST = 1_000_000
    private const val RESOLUTION = 1e-10

    /**
     * x0, y0, …, both ends exact. Without a [spacing] a line stays whole, and a curve is divided into equal lengths so that
     * none bends by more than ten degrees on the average.
     *
     * @param isAlone whether the piece is a loop by itself, which needs three nodes.
     */
    fun points(piece: OutlinePiece, spacing: Double, ratio: Double, isAlone: Boolean): DoubleArray {
        val curve = piece.curve
        if (curve is StraightLine && spacing.isNaN() && piece.division == null) {
            return doubleArrayOf(curve.beginX, curve.beginY, curve.endX, curve.endY)
        }
        val ends = doubleArrayOf(curve.beginX, curve.beginY, curve.endX, curve.endY)
        if (!isResolved(curve)) return ends
        val track = CurveTrack(curve)
        if (!(track.length > 0 && track.length < Double.POSITIVE_INFINITY)) return ends
        val least = if (isAlone) 3 else 1
        if (spacing.isNaN()) {
            val division = piece.division ?: OutlineDivision(maxOf(least, byBend(curve)), 1.0)
            return place(track, fractions(maxOf(least, division.count), division.ratio, Distribution.GEOMETRIC))
        }
        val traits = Traits("curve", spacing, ratio)
        val count = maxOf(least, Intervals.count(track.length, traits, TrackExploder.growth(traits)))
        return place(track, fractions(count, ratio, Distribution.LINEAR))
    }

    /** Length of a curve. */
    fun length(curve: PlaneCurve): Double = CurveTrack(curve).length

    /** [Intervals] has the short intervals first. */
    private fun fractions(count: Int, ratio: Double, distribution: Distribution): DoubleArray {
        if (count > MOST) throw InvalidShapeException("curve: $count intervals are too many")
        if (ratio >= 1) return Intervals.fractions(count, ratio, distribution)
        val t = Intervals.fractions(count, 1 / ratio, distribution)
        return DoubleArray(count + 1) { if (it == 0) 0.0 else if (it == count) 1.0 else 1 - t[count - it] }
    }

    private fun place(track: CurveTrack, fractions: DoubleArray): DoubleArray {
        val xy = DoubleArray(2 * fractions.size)
        for (k in fractions.indices) track.place(fractions[k], xy, k)
        return xy
    }

    /** Whether the curve is large enough for its coordinates to tell its points apart. */
    private fun isResolved(curve: PlaneCurve): Boolean {
        var size = 0.0
        var largest = 0.0
        for (i in 0..SAMPLES) {
            val u = curve.knots.first() + (curve.knots.last() - curve.knots.first()) * i / SAMPLES
            val x = curve.x(u)
            val y = curve.y(u)
            size = maxOf(size, Math.abs(x - curve.beginX), Math.abs(y - curve.beginY))
            largest = maxOf(largest, Math.abs(x), Math.abs(y))
        }
        return size > RESOLUTION * largest
    }

    /** How far the curve turns altogether, divided by the bend that is allowed. */
    private fun byBend(curve: PlaneCurve): Int {
        var bend = 0.0
        var dx = 0.0
        var dy = 0.0
        for (i in 1 until curve.knots.size) {
            for (k in 1..SAMPLES) {
                val from = curve.knots[i - 1] + (curve.knots[i] - curve.knots[i - 1]) * (k - 1) / SAMPLES
                val to = curve.knots[i - 1] + (curve.knots[i] - curve.knots[i - 1]) * k / SAMPLES
                val ex = curve.x(to) - curve.x(from)
                val ey = curve.y(to) - curve.y(from)
                if (ex == 0.0 && ey == 0.0) continue
                if (dx != 0.0 || dy != 0.0) bend += Math.abs(StrictMath.atan2(dx * ey - dy * ex, dx * ex + dy * ey))
                dx = ex
                dy = ey
            }
        }
        return Math.min(Math.max(Math.ceil(bend / LARGEST_BEND - 1e-6), 1.0), 1e5).toInt()
    }
}

private class CurveTrack(private val curve: PlaneCurve) : Track {
    private val arcs = if (curve is StraightLine) null else ArcLength(Speed { curve.speed(it) }, curve.knots)

    override val length: Double = arcs?.length ?: curve.speed(0.0)

    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val u = if (arcs == null || fraction == 0.0 || fraction == 1.0) fraction else arcs.parameterAt(fraction * length)
        xy[2 * index] = if (fraction == 0.0) curve.beginX else if (fraction == 1.0) curve.endX else curve.x(u)
        xy[2 * index + 1] = if (fraction == 0.0) curve.beginY else if (fraction == 1.0) curve.endY else curve.y(u)
    }
}
