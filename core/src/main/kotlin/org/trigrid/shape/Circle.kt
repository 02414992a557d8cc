package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A circle (the paper's Circle object), exploded by arc length.
 *
 * @param firstPoint the point of the perimeter that connects the circle to the domain; it sets the radius.
 */
public class Circle internal constructor(
    firstPoint: Point2,
    @get:JvmName("centre") public val centre: Point2,
    @get:JvmName("direction") public val direction: Direction,
    traits: Traits,
) : Shape(traits, firstPoint, firstPoint) {
    /** Distance of the first point from the centre, in the domain's unit. */
    @get:JvmName("radius")
    public val radius: Double

    init {
        Traits.finite(traits.kind, "firstPoint", firstPoint)
        Traits.finite(traits.kind, "centre", centre)
        radius = StrictMath.hypot(firstPoint.x - centre.x, firstPoint.y - centre.y)
        Traits.positive(traits.kind, "radius", radius)
    }

    /**
     * An anticlockwise circle.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be, or the radius is 0.
     */
    public constructor(firstPoint: Point2, centre: Point2, spacing: Double) :
        this(firstPoint, centre, Direction.ANTICLOCKWISE, Traits(KIND, spacing))

    /** An anticlockwise circle that begins at its rightmost point. */
    public constructor(centreX: Double, centreY: Double, radius: Double, spacing: Double) :
        this(rightmost(centreX, centreY, radius), Point2(centreX, centreY), spacing)

    /** The same circle about another centre, its first point moved along. */
    public fun withCentre(value: Point2): Circle {
        val first = Point2(firstPoint.x + (value.x - centre.x), firstPoint.y + (value.y - centre.y))
        return Circle(first, value, direction, traits)
    }

    /** Another radius; the first point moves along its ray from the centre. */
    public fun withRadius(value: Double): Circle {
        Traits.positive(traits.kind, "radius", value)
        val scale = value / radius
        val first = Point2(centre.x + scale * (firstPoint.x - centre.x), centre.y + scale * (firstPoint.y - centre.y))
        return Circle(first, centre, direction, traits)
    }

    /** Another first point; the radius becomes its distance from the centre. */
    public fun withFirstPoint(value: Point2): Circle = Circle(value, centre, direction, traits)

    /** The same place travelled in the direction [value]. */
    public fun withDirection(value: Direction): Circle = Circle(firstPoint, centre, value, traits)

    override fun withSpacing(value: Double): Circle = with(traits.spacing(value))

    override fun withRatio(value: Double): Circle = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Circle = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Circle = with(traits.rounding(value))

    override fun withName(value: String): Circle = with(traits.name(value))

    private fun with(traits: Traits): Circle = Circle(firstPoint, centre, direction, traits)

    override fun isClosed(): Boolean = true

    override fun reversed(): Circle = Circle(firstPoint, centre, direction.opposite(), traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray =
        TrackExploder.explode(traits, direction == Direction.ANTICLOCKWISE, ::track)

    override fun track(): Track = track(true)

    private fun track(forward: Boolean) = CircleTrack(firstPoint, centre, radius, if (forward) direction.sign else -direction.sign)

    override fun geometry(): List<Any> = listOf(firstPoint, centre, direction)

    public companion object {
        private const val KIND = "circle"

        /** Explodes a circle into nodes x0, y0, x1, y1, …; [firstPoint] is the first and again the last. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            firstPoint: Point2,
            centre: Point2,
            direction: Direction,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray = Circle(firstPoint, centre, direction, Traits(KIND, spacing, ratio, distribution, rounding)).explode()

        private fun rightmost(centreX: Double, centreY: Double, radius: Double): Point2 {
            Traits.positive(KIND, "radius", radius)
            return Point2(centreX + radius, centreY)
        }
    }
}

private class CircleTrack(
    private val first: Point2,
    private val centre: Point2,
    radius: Double,
    private val sign: Int,
) : Track {
    override val length: Double = 2 * Math.PI * radius

    /** The first point turned about the centre. */
    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val isEnd = fraction == 0.0 || fraction == 1.0
        val dx = first.x - centre.x
        val dy = first.y - centre.y
        val cos = Turn.cos(fraction)
        val sin = sign * Turn.sin(fraction)
        xy[2 * index] = if (isEnd) first.x else centre.x + (dx * cos - dy * sin)
        xy[2 * index + 1] = if (isEnd) first.y else centre.y + (dx * sin + dy * cos)
    }
}
