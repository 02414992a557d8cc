package org.trigrid.shape

import org.trigrid.geometry.Point2

/** A straight line (the paper's Line object, appendix A). */
public class Line internal constructor(begin: Point2, end: Point2, traits: Traits) : Shape(traits, begin, end) {
    init {
        check(begin, end, traits.kind)
    }

    /** @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be, or the ends coincide. */
    public constructor(begin: Point2, end: Point2, spacing: Double) : this(begin, end, Traits(KIND, spacing))

    /** From the coordinates of the ends. */
    public constructor(beginX: Double, beginY: Double, endX: Double, endY: Double, spacing: Double) :
        this(Point2(beginX, beginY), Point2(endX, endY), spacing)

    /** Between other ends. */
    public fun withEnds(begin: Point2, end: Point2): Line = Line(begin, end, traits)

    override fun withSpacing(value: Double): Line = with(traits.spacing(value))

    override fun withRatio(value: Double): Line = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Line = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Line = with(traits.rounding(value))

    override fun withName(value: String): Line = with(traits.name(value))

    private fun with(traits: Traits): Line = Line(firstPoint, lastPoint, traits)

    override fun isClosed(): Boolean = false

    override fun reversed(): Line = Line(lastPoint, firstPoint, traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray = explode(firstPoint, lastPoint, traits)

    override fun geometry(): List<Any> = listOf(firstPoint, lastPoint)

    public companion object {
        private const val KIND = "line"

        /** Explodes the line from [begin] to [end] into nodes x0, y0, x1, y1, …, ends included and exact. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            begin: Point2,
            end: Point2,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray {
            check(begin, end, KIND)
            return explode(begin, end, Traits(KIND, spacing, ratio, distribution, rounding))
        }

        internal fun explode(begin: Point2, end: Point2, traits: Traits): DoubleArray =
            TrackExploder.explode(traits, begin.x < end.x || begin.x == end.x && begin.y < end.y) { forward ->
                if (forward) LineTrack(begin, end) else LineTrack(end, begin)
            }

        private fun check(begin: Point2, end: Point2, kind: String) {
            Traits.finite(kind, "begin", begin)
            Traits.finite(kind, "end", end)
            if (Traits.samePlace(begin, end)) Traits.refuse(kind, "begin and end are the same place, $begin")
        }
    }
}

private class LineTrack(private val begin: Point2, private val end: Point2) : Track {
    override val length: Double = StrictMath.hypot(end.x - begin.x, end.y - begin.y)

    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val isEnd = fraction == 1.0
        xy[2 * index] = if (isEnd) end.x else begin.x + fraction * (end.x - begin.x)
        xy[2 * index + 1] = if (isEnd) end.y else begin.y + fraction * (end.y - begin.y)
    }
}
