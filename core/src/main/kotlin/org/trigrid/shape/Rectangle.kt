package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A rectangle with sides along the axes (the paper's Rectangle object); the ratio applies to each of its sides.
 *
 * @param begin the corner that connects the rectangle to the domain, [firstPoint].
 */
public class Rectangle internal constructor(
    begin: Point2,
    /** The corner opposite the begin corner. */
    @get:JvmName("endCorner") public val endCorner: Point2,
    @get:JvmName("direction") public val direction: Direction,
    traits: Traits,
) : Shape(traits, begin, begin) {
    init {
        Traits.finite(traits.kind, "begin", begin)
        Traits.finite(traits.kind, "end", endCorner)
        if (begin.x == endCorner.x) Traits.refuse(traits.kind, "width is 0")
        if (begin.y == endCorner.y) Traits.refuse(traits.kind, "height is 0")
    }

    /**
     * An anticlockwise rectangle.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be, or a side has no length.
     */
    public constructor(begin: Point2, end: Point2, spacing: Double) :
        this(begin, end, Direction.ANTICLOCKWISE, Traits(KIND, spacing))

    /** From the coordinates of two opposite corners. */
    public constructor(beginX: Double, beginY: Double, endX: Double, endY: Double, spacing: Double) :
        this(Point2(beginX, beginY), Point2(endX, endY), spacing)

    /** Between other opposite corners. */
    public fun withCorners(begin: Point2, end: Point2): Rectangle = Rectangle(begin, end, direction, traits)

    /** The same place travelled in the direction [value]. */
    public fun withDirection(value: Direction): Rectangle = Rectangle(firstPoint, endCorner, value, traits)

    override fun withSpacing(value: Double): Rectangle = with(traits.spacing(value))

    override fun withRatio(value: Double): Rectangle = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Rectangle = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Rectangle = with(traits.rounding(value))

    override fun withName(value: String): Rectangle = with(traits.name(value))

    private fun with(traits: Traits): Rectangle = Rectangle(firstPoint, endCorner, direction, traits)

    override fun isClosed(): Boolean = true

    override fun reversed(): Rectangle = Rectangle(firstPoint, endCorner, direction.opposite(), traits.reversed())

    /** The corners in the order of travel, the begin corner first and again last. */
    internal fun corners(): List<Point2> {
        val b = firstPoint
        val e = endCorner
        val alongX = Point2(e.x, b.y)
        val alongY = Point2(b.x, e.y)
        val startsAlongX = (e.x > b.x == e.y > b.y) == (direction == Direction.ANTICLOCKWISE)
        return if (startsAlongX) listOf(b, alongX, e, alongY, b) else listOf(b, alongY, e, alongX, b)
    }

    override fun explodeWith(traits: Traits): DoubleArray = SideExploder.explode(corners(), traits)

    override fun geometry(): List<Any> = listOf(firstPoint, endCorner, direction)

    public companion object {
        private const val KIND = "rectangle"

        /** Explodes a rectangle into nodes x0, y0, x1, y1, …; the begin corner is the first and again the last. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            begin: Point2,
            end: Point2,
            direction: Direction,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray = Rectangle(begin, end, direction, Traits(KIND, spacing, ratio, distribution, rounding)).explode()
    }
}
