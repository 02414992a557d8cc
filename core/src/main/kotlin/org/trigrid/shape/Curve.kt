package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A smooth curve through vertices (the paper's Curve object): a cubic spline, exploded by arc length.
 *
 * The spline's parameter grows by the square root of the distance between neighbouring vertices (centripetal; Lee 1989,
 * Computer-Aided Design 21:363-370), so that unevenly spaced vertices, as traced ones are, make no loops or cusps.
 * Its ends are nodes; the vertices between are places the curve runs through, not nodes.
 */
public class Curve internal constructor(
    vertices: List<Point2>,
    @get:JvmName("ends") public val ends: CurveEnds,
    /** Direction at the first vertex, any length above 0; null unless the ends are clamped. */
    @get:JvmName("beginTangent") public val beginTangent: Point2?,
    /** Direction at the last vertex, any length above 0; null unless the ends are clamped. */
    @get:JvmName("endTangent") public val endTangent: Point2?,
    traits: Traits,
) : Shape(traits, checkedFirst(vertices, ends, traits), if (ends == CurveEnds.CLOSED) vertices.first() else vertices.last()) {
    /** The places the curve runs through, in the order of travel: at least two, three for a closed curve. */
    @get:JvmName("vertices")
    public val vertices: List<Point2> = java.util.List.copyOf(vertices)

    init {
        require((ends == CurveEnds.CLAMPED) == (beginTangent != null && endTangent != null)) { "tangents are for clamped ends" }
        beginTangent?.let { checkTangent("beginTangent", it) }
        endTangent?.let { checkTangent("endTangent", it) }
    }

    /**
     * A curve with natural ends.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be.
     */
    public constructor(vertices: List<Point2>, spacing: Double) :
        this(vertices, CurveEnds.NATURAL, null, null, Traits(KIND, spacing))

    /** The same vertices, no curvature at the ends. */
    public fun natural(): Curve = Curve(vertices, CurveEnds.NATURAL, null, null, traits)

    /** The same vertices, leaving and arriving in the given directions, whose lengths do not matter. */
    public fun clamped(beginTangent: Point2, endTangent: Point2): Curve =
        Curve(vertices, CurveEnds.CLAMPED, beginTangent, endTangent, traits)

    /** The same vertices, the last joined smoothly to the first; a last vertex at the place of the first is left out. */
    public fun closed(): Curve {
        val repeated = vertices.size > 1 && Traits.samePlace(vertices.first(), vertices.last())
        return Curve(if (repeated) vertices.dropLast(1) else vertices, CurveEnds.CLOSED, null, null, traits)
    }

    /** Through other points. */
    public fun withVertices(value: List<Point2>): Curve = Curve(value, ends, beginTangent, endTangent, traits)

    override fun withSpacing(value: Double): Curve = with(traits.spacing(value))

    override fun withRatio(value: Double): Curve = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Curve = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Curve = with(traits.rounding(value))

    override fun withName(value: String): Curve = with(traits.name(value))

    private fun with(traits: Traits): Curve = Curve(vertices, ends, beginTangent, endTangent, traits)

    override fun isClosed(): Boolean = Traits.samePlace(firstPoint, lastPoint)

    override fun reversed(): Curve = Curve(
        backVertices(), ends, endTangent?.let(::opposite), beginTangent?.let(::opposite), traits.reversed(),
    )

    override fun explodeWith(traits: Traits): DoubleArray =
        TrackExploder.explode(traits, isCanonical(), ::track)

    override fun track(): Track = track(true)

    private fun track(forward: Boolean) = SplineTrack(Spline.through(if (forward) this else reversed()))

    override fun geometry(): List<Any> = listOf(vertices, ends, beginTangent.toString(), endTangent.toString())

    private fun isCanonical(): Boolean {
        val back = backVertices()
        for (i in vertices.indices) {
            val a = vertices[i]
            val b = back[i]
            if (a.x != b.x) return a.x < b.x
            if (a.y != b.y) return a.y < b.y
        }
        return true
    }

    private fun backVertices(): List<Point2> =
        if (ends == CurveEnds.CLOSED) Polygon.turned(vertices) else vertices.reversed()

    private fun checkTangent(field: String, tangent: Point2) {
        Traits.finite(traits.kind, field, tangent)
        if (tangent.x == 0.0 && tangent.y == 0.0) Traits.refuse(traits.kind, "$field has no direction")
    }

    private fun opposite(tangent: Point2): Point2 = Point2(-tangent.x, -tangent.y)

    public companion object {
        private const val KIND = "curve"

        /** A curve with natural ends through the points x0, y0, x1, y1, … */
        @JvmStatic
        public fun of(spacing: Double, vararg coordinates: Double): Curve =
            Curve(Traits.points(KIND, coordinates), spacing)

        /** Explodes a curve with natural or closed ends into nodes x0, y0, x1, y1, …, ends included and exact. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            vertices: List<Point2>,
            isClosed: Boolean,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray {
            val ends = if (isClosed) CurveEnds.CLOSED else CurveEnds.NATURAL
            return Curve(vertices, ends, null, null, Traits(KIND, spacing, ratio, distribution, rounding)).explode()
        }

        private fun checkedFirst(vertices: List<Point2>, ends: CurveEnds, traits: Traits): Point2 {
            val closed = ends == CurveEnds.CLOSED
            return Traits.vertices(traits.kind, vertices, if (closed) 3 else 2, closed).first()
        }
    }
}
