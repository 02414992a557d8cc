package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A closed polygon (the paper's Polygon object), regular or with a given set of vertices. Every vertex is a node.
 *
 * Spacing and ratio apply to the whole perimeter: the intervals a side gets are those that the perimeter, cut as one
 * line, would have along it, rounded to a whole number for each side. With ratio 1 all intervals of a side are alike.
 */
public class Polygon internal constructor(
    vertices: List<Point2>,
    private val regularCentre: Point2?,
    traits: Traits,
) : Shape(traits, Traits.vertices(traits.kind, vertices, 3, true).first(), vertices.first()) {
    /** The vertices in the order of travel, the first point first; the last is joined to it. */
    @get:JvmName("vertices")
    public val vertices: List<Point2> = java.util.List.copyOf(vertices)

    /** Centre of a regular polygon's circumcircle; else the mean of the vertices. */
    @get:JvmName("centre")
    public val centre: Point2 = regularCentre
        ?: Point2(vertices.sumOf { it.x } / vertices.size, vertices.sumOf { it.y } / vertices.size)

    /** A polygon with the given vertices, travelled in their order. */
    public constructor(vertices: List<Point2>, spacing: Double) : this(vertices, null, Traits(KIND, spacing))

    /** A regular polygon, anticlockwise; the first point is a vertex and sets the radius. */
    public constructor(firstPoint: Point2, centre: Point2, vertexCount: Int, spacing: Double) :
        this(regular(firstPoint, centre, vertexCount, Direction.ANTICLOCKWISE), centre, Traits(KIND, spacing))

    /** Distance of the first point from the centre, in the domain's unit. */
    @get:JvmName("radius")
    public val radius: Double get() = centre.distanceTo(firstPoint)

    /** Whether the polygon was made from a centre and a number of vertices. */
    @get:JvmName("isRegular")
    public val isRegular: Boolean get() = regularCentre != null

    /** The way round the vertices are travelled. */
    @get:JvmName("direction")
    public val direction: Direction get() = if (doubledArea() < 0) Direction.CLOCKWISE else Direction.ANTICLOCKWISE

    /** Travelled in the given direction from the same first point. */
    public fun withDirection(value: Direction): Polygon =
        if (value == direction) this else Polygon(turned(vertices), regularCentre, traits)

    override fun withSpacing(value: Double): Polygon = with(traits.spacing(value))

    override fun withRatio(value: Double): Polygon = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Polygon = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Polygon = with(traits.rounding(value))

    override fun withName(value: String): Polygon = with(traits.name(value))

    private fun with(traits: Traits): Polygon = Polygon(vertices, regularCentre, traits)

    override fun isClosed(): Boolean = true

    override fun reversed(): Polygon = Polygon(turned(vertices), regularCentre, traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray =
        TrackExploder.checkDistinct(PerimeterExploder.explode(vertices, traits), traits)

    override fun geometry(): List<Any> = listOf(vertices, centre, isRegular)

    private fun doubledArea(): Double {
        var sum = 0.0
        for (i in 1 until vertices.size - 1) {
            val a = vertices[i]
            val b = vertices[i + 1]
            sum += (a.x - firstPoint.x) * (b.y - firstPoint.y) - (b.x - firstPoint.x) * (a.y - firstPoint.y)
        }
        return sum
    }

    public companion object {
        private const val KIND = "polygon"

        /** A regular polygon with more is a mistake. */
        private const val MOST_VERTICES = 1_000_000

        /** A polygon with the vertices x0, y0, x1, y1, … */
        @JvmStatic
        public fun of(spacing: Double, vararg coordinates: Double): Polygon =
            Polygon(Traits.points(KIND, coordinates), spacing)

        /** Explodes a polygon into nodes x0, y0, x1, y1, …; the first vertex is the first and again the last. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            vertices: List<Point2>,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray = Polygon(vertices, null, Traits(KIND, spacing, ratio, distribution, rounding)).explode()

        /** Vertices of a regular polygon, [first] first. */
        internal fun regular(first: Point2, centre: Point2, count: Int, direction: Direction): List<Point2> {
            if (count < 3) Traits.refuse(KIND, "vertexCount must be at least 3, not $count")
            if (count > MOST_VERTICES) Traits.refuse(KIND, "vertexCount must be at most $MOST_VERTICES, not $count")
            Traits.finite(KIND, "firstPoint", first)
            Traits.finite(KIND, "centre", centre)
            if (Traits.samePlace(first, centre)) Traits.refuse(KIND, "radius must be a number above 0, not 0.0")
            val dx = first.x - centre.x
            val dy = first.y - centre.y
            val anticlockwise = List(count) {
                val cos = Turn.cos(it.toDouble() / count)
                val sin = Turn.sin(it.toDouble() / count)
                if (it == 0) first else Point2(centre.x + (dx * cos - dy * sin), centre.y + (dx * sin + dy * cos))
            }
            return if (direction == Direction.ANTICLOCKWISE) anticlockwise else turned(anticlockwise)
        }

        /** The same closed walk the other way, from the same first vertex. */
        internal fun turned(vertices: List<Point2>): List<Point2> =
            listOf(vertices.first()) + vertices.drop(1).reversed()
    }
}
