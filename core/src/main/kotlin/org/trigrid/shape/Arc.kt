package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A circular arc between two points, exploded by arc length. Beyond the paper.
 */
public class Arc internal constructor(
    begin: Point2,
    end: Point2,
    /**
     * How far the arc turns from begin to end, in degrees: above 0 anticlockwise, below 0 clockwise; -360..360, neither
     * 0 nor a full turn. 180 is the half circle to the right of the way from begin to end.
     */
    @get:JvmName("angleDegrees") public val angleDegrees: Double,
    traits: Traits,
) : Shape(traits, begin, end) {
    init {
        Traits.finite(traits.kind, "begin", begin)
        Traits.finite(traits.kind, "end", end)
        if (Traits.samePlace(begin, end)) Traits.refuse(traits.kind, "begin and end are the same place, $begin")
        if (!(Math.abs(angleDegrees) < FULL_TURN) || angleDegrees == 0.0) {
            Traits.refuse(traits.kind, "angleDegrees must be within -360 and 360 and not 0, not $angleDegrees")
        }
    }

    /** @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be. */
    public constructor(begin: Point2, end: Point2, angleDegrees: Double, spacing: Double) :
        this(begin, end, angleDegrees, Traits(KIND, spacing))

    /** Radius of the arc's circle, in the domain's unit. */
    @get:JvmName("radius")
    public val radius: Double
        get() = firstPoint.distanceTo(lastPoint) / (2 * Turn.sin(Math.abs(angleDegrees) / FULL_TURN / 2))

    /** The same bend between other ends. */
    public fun withEnds(begin: Point2, end: Point2): Arc = Arc(begin, end, angleDegrees, traits)

    /** With the angle [value] that the arc turns through, in degrees. */
    public fun withAngleDegrees(value: Double): Arc = Arc(firstPoint, lastPoint, value, traits)

    override fun withSpacing(value: Double): Arc = with(traits.spacing(value))

    override fun withRatio(value: Double): Arc = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Arc = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Arc = with(traits.rounding(value))

    override fun withName(value: String): Arc = with(traits.name(value))

    private fun with(traits: Traits): Arc = Arc(firstPoint, lastPoint, angleDegrees, traits)

    override fun isClosed(): Boolean = false

    override fun reversed(): Arc = Arc(lastPoint, firstPoint, -angleDegrees, traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray =
        TrackExploder.explode(traits, angleDegrees > 0, ::track)

    override fun track(): Track = track(true)

    private fun track(forward: Boolean) =
        if (forward) ArcTrack(firstPoint, lastPoint, angleDegrees / FULL_TURN) else ArcTrack(lastPoint, firstPoint, -angleDegrees / FULL_TURN)

    override fun geometry(): List<Any> = listOf(firstPoint, lastPoint, angleDegrees)

    public companion object {
        private const val KIND = "arc"
        private const val FULL_TURN = 360.0

        /** Explodes an arc into nodes x0, y0, x1, y1, …, ends included and exact. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            begin: Point2,
            end: Point2,
            angleDegrees: Double,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray = Arc(begin, end, angleDegrees, Traits(KIND, spacing, ratio, distribution, rounding)).explode()

        /**
         * The arc from [begin] to [end] that passes through [middle].
         *
         * @throws org.trigrid.diagnostics.InvalidShapeException if the three points lie on a line.
         */
        @JvmStatic
        public fun through(begin: Point2, middle: Point2, end: Point2, spacing: Double): Arc {
            // The inscribed angle at the middle point spans the rest of the circle: half of what the arc leaves out.
            val ux = begin.x - middle.x
            val uy = begin.y - middle.y
            val vx = end.x - middle.x
            val vy = end.y - middle.y
            val inscribed = Turn.of(ux * vx + uy * vy, ux * vy - uy * vx) * FULL_TURN
            if (inscribed == 0.0 || Math.abs(inscribed) == FULL_TURN / 2) Traits.refuse(KIND, "points lie on a line")
            val angle = if (inscribed < 0) FULL_TURN + 2 * inscribed else 2 * inscribed - FULL_TURN
            return Arc(begin, end, angle, spacing)
        }

        /** The arc about [centre] from [begin] to [end]; the distance of [begin] from the centre sets the radius. */
        @JvmStatic
        public fun around(centre: Point2, begin: Point2, end: Point2, direction: Direction, spacing: Double): Arc {
            val ux = begin.x - centre.x
            val uy = begin.y - centre.y
            val vx = end.x - centre.x
            val vy = end.y - centre.y
            val turns = direction.sign * Turn.of(ux * vx + uy * vy, ux * vy - uy * vx)
            return Arc(begin, end, direction.sign * FULL_TURN * (if (turns < 0) turns + 1 else turns), spacing)
        }
    }
}

/**
 * The chord from the begin to the point at angle t of an arc of angle a is the whole chord, turned by (t - a) / 2 and
 * scaled by sin(t / 2) / sin(a / 2): no centre, so flat arcs are as exact as others.
 */
private class ArcTrack(private val begin: Point2, private val end: Point2, private val turns: Double) : Track {
    private val halfSine = Turn.sin(turns / 2)

    override val length: Double =
        StrictMath.hypot(end.x - begin.x, end.y - begin.y) * (Math.PI * turns / halfSine)

    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val isEnd = fraction == 1.0
        val scale = Turn.sin(fraction * turns / 2) / halfSine
        val angle = (fraction - 1) * turns / 2
        val cos = scale * Turn.cos(angle)
        val sin = scale * Turn.sin(angle)
        val dx = end.x - begin.x
        val dy = end.y - begin.y
        xy[2 * index] = if (isEnd) end.x else begin.x + (dx * cos - dy * sin)
        xy[2 * index + 1] = if (isEnd) end.y else begin.y + (dx * sin + dy * cos)
    }
}
