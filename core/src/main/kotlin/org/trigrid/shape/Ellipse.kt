package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * An ellipse (the paper's Ellipse object, with a rotation), exploded by arc length.
 *
 * @param firstPoint the point of the perimeter that connects the ellipse to the domain.
 */
public class Ellipse internal constructor(
    firstPoint: Point2,
    @get:JvmName("centre") public val centre: Point2,
    /** Radius along the ellipse's own x axis, in the domain's unit, > 0. */
    @get:JvmName("radiusX") public val radiusX: Double,
    /** Radius along the ellipse's own y axis, in the domain's unit, > 0. */
    @get:JvmName("radiusY") public val radiusY: Double,
    /** Angle from the x axis to the ellipse's own x axis, in degrees, anticlockwise. */
    @get:JvmName("rotationDegrees") public val rotationDegrees: Double,
    @get:JvmName("direction") public val direction: Direction,
    traits: Traits,
) : Shape(traits, firstPoint, firstPoint) {
    private val frame: EllipseFrame

    init {
        val kind = traits.kind
        Traits.finite(kind, "firstPoint", firstPoint)
        Traits.finite(kind, "centre", centre)
        Traits.positive(kind, "radiusX", radiusX)
        Traits.positive(kind, "radiusY", radiusY)
        Traits.finite(kind, "rotationDegrees", rotationDegrees)
        frame = EllipseFrame(firstPoint, centre, radiusX, radiusY, rotationDegrees / FULL_TURN)
        if (!(Math.abs(frame.level - 1) <= ON_PERIMETER)) {
            Traits.refuse(kind, "firstPoint $firstPoint is not on the perimeter (${frame.level} of the radius there)")
        }
    }

    /**
     * An anticlockwise ellipse with axes along x and y.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be, or the first point is
     *   further off the perimeter than a millionth of the radius.
     */
    public constructor(firstPoint: Point2, centre: Point2, radiusX: Double, radiusY: Double, spacing: Double) :
        this(firstPoint, centre, radiusX, radiusY, 0.0, Direction.ANTICLOCKWISE, Traits(KIND, spacing))

    /** An anticlockwise ellipse that begins at its rightmost point. */
    public constructor(centreX: Double, centreY: Double, radiusX: Double, radiusY: Double, spacing: Double) :
        this(Point2(centreX + radiusX, centreY), Point2(centreX, centreY), radiusX, radiusY, spacing)

    /** The same ellipse about another centre, its first point moved along. */
    public fun withCentre(value: Point2): Ellipse {
        val first = Point2(firstPoint.x + (value.x - centre.x), firstPoint.y + (value.y - centre.y))
        return Ellipse(first, value, radiusX, radiusY, rotationDegrees, direction, traits)
    }

    /** Other radii; the first point stays at its parameter angle. */
    public fun withRadii(radiusX: Double, radiusY: Double): Ellipse = moved(radiusX, radiusY, rotationDegrees)

    /** Turned to another angle; the first point turns along. */
    public fun withRotationDegrees(value: Double): Ellipse = moved(radiusX, radiusY, value)

    /** Begins at another point of the perimeter. */
    public fun withFirstPoint(value: Point2): Ellipse =
        Ellipse(value, centre, radiusX, radiusY, rotationDegrees, direction, traits)

    /** Begins at the point of the perimeter in the direction of [towards] as seen in the ellipse's parameter angle. */
    public fun withFirstPointTowards(towards: Point2): Ellipse {
        val turns = EllipseFrame(towards, centre, radiusX, radiusY, rotationDegrees / FULL_TURN).begin
        return withFirstPoint(frame.pointAt(turns))
    }

    /** The same place travelled in the direction [value]. */
    public fun withDirection(value: Direction): Ellipse =
        Ellipse(firstPoint, centre, radiusX, radiusY, rotationDegrees, value, traits)

    override fun withSpacing(value: Double): Ellipse = with(traits.spacing(value))

    override fun withRatio(value: Double): Ellipse = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Ellipse = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Ellipse = with(traits.rounding(value))

    override fun withName(value: String): Ellipse = with(traits.name(value))

    private fun with(traits: Traits): Ellipse =
        Ellipse(firstPoint, centre, radiusX, radiusY, rotationDegrees, direction, traits)

    private fun moved(radiusX: Double, radiusY: Double, rotationDegrees: Double): Ellipse {
        val frame = EllipseFrame(firstPoint, centre, radiusX, radiusY, rotationDegrees / FULL_TURN)
        return Ellipse(
            frame.pointAt(this.frame.begin), centre, radiusX, radiusY, rotationDegrees, direction, traits,
        )
    }

    override fun isClosed(): Boolean = true

    override fun reversed(): Ellipse =
        Ellipse(firstPoint, centre, radiusX, radiusY, rotationDegrees, direction.opposite(), traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray =
        TrackExploder.explode(traits, direction == Direction.ANTICLOCKWISE, ::track)

    override fun track(): Track = track(true)

    private fun track(forward: Boolean) = EllipseTrack(firstPoint, frame, if (forward) direction.sign else -direction.sign)

    override fun geometry(): List<Any> = listOf(firstPoint, centre, radiusX, radiusY, rotationDegrees, direction)

    public companion object {
        private const val KIND = "ellipse"
        private const val FULL_TURN = 360.0

        /** How far off the perimeter a first point may be, as part of the radius: what single precision leaves. */
        private const val ON_PERIMETER = 1e-6

        /** Explodes an ellipse into nodes x0, y0, x1, y1, …; [firstPoint] is the first and again the last. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            firstPoint: Point2,
            centre: Point2,
            radiusX: Double,
            radiusY: Double,
            rotationDegrees: Double,
            direction: Direction,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray {
            val traits = Traits(KIND, spacing, ratio, distribution, rounding)
            return Ellipse(firstPoint, centre, radiusX, radiusY, rotationDegrees, direction, traits).explode()
        }
    }
}

/** The ellipse's own axes; parameters are parts of a turn. */
private class EllipseFrame(
    first: Point2,
    private val centre: Point2,
    private val radiusX: Double,
    private val radiusY: Double,
    rotationTurns: Double,
) {
    private val cos = Turn.cos(rotationTurns)
    private val sin = Turn.sin(rotationTurns)
    private val alongX = ((first.x - centre.x) * cos + (first.y - centre.y) * sin) / radiusX
    private val alongY = ((first.y - centre.y) * cos - (first.x - centre.x) * sin) / radiusY

    /** 1 where the first point is on the perimeter. */
    val level: Double = StrictMath.hypot(alongX, alongY)

    /** Parameter of the first point. */
    val begin: Double = Turn.of(alongX, alongY)

    fun pointAt(turns: Double): Point2 {
        val x = radiusX * Turn.cos(turns)
        val y = radiusY * Turn.sin(turns)
        return Point2(centre.x + (x * cos - y * sin), centre.y + (x * sin + y * cos))
    }

    /** Length per turn. */
    fun speedAt(turns: Double): Double =
        2 * Math.PI * StrictMath.sqrt(square(radiusX * Turn.sin(turns)) + square(radiusY * Turn.cos(turns)))

    private fun square(value: Double): Double = value * value
}

private class EllipseTrack(private val first: Point2, private val frame: EllipseFrame, private val sign: Int) : Track {
    private val arcLength = ArcLength(
        { u -> frame.speedAt(frame.begin + sign * u) },
        doubleArrayOf(0.0, 0.25, 0.5, 0.75, 1.0),
    )

    override val length: Double get() = arcLength.length

    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val isEnd = fraction == 0.0 || fraction == 1.0
        val point = if (isEnd) first else frame.pointAt(frame.begin + sign * arcLength.parameterAt(fraction * length))
        xy[2 * index] = point.x
        xy[2 * index + 1] = point.y
    }
}
