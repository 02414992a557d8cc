package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * Successive straight lines (the paper's Lines object); spacing and ratio apply to each line.
 *
 * Closed where the last vertex is at the place of the first.
 */
public class Lines internal constructor(vertices: List<Point2>, traits: Traits) :
    Shape(traits, Traits.vertices(traits.kind, vertices, 2, false).first(), vertices.last()) {
    /** The ends of the lines, at least two, no two neighbours at one place. Each of them is a node. */
    @get:JvmName("vertices")
    public val vertices: List<Point2> = java.util.List.copyOf(vertices)

    /** @throws org.trigrid.diagnostics.InvalidShapeException if a field is not what it must be. */
    public constructor(vertices: List<Point2>, spacing: Double) : this(vertices, Traits(KIND, spacing))

    /** Through other points. */
    public fun withVertices(value: List<Point2>): Lines = Lines(value, traits)

    override fun withSpacing(value: Double): Lines = with(traits.spacing(value))

    override fun withRatio(value: Double): Lines = with(traits.ratio(value))

    override fun withDistribution(value: Distribution): Lines = with(traits.distribution(value))

    override fun withRounding(value: Rounding): Lines = with(traits.rounding(value))

    override fun withName(value: String): Lines = with(traits.name(value))

    private fun with(traits: Traits): Lines = Lines(vertices, traits)

    override fun isClosed(): Boolean = Traits.samePlace(firstPoint, lastPoint)

    override fun reversed(): Lines = Lines(vertices.reversed(), traits.reversed())

    override fun explodeWith(traits: Traits): DoubleArray = SideExploder.explode(vertices, traits)

    override fun geometry(): List<Any> = vertices

    public companion object {
        internal const val KIND = "lines"

        /** Lines through the points x0, y0, x1, y1, … */
        @JvmStatic
        public fun of(spacing: Double, vararg coordinates: Double): Lines =
            Lines(Traits.points(KIND, coordinates), spacing)

        /** Explodes each of the lines through [vertices] into nodes x0, y0, x1, y1, …; every vertex is a node. */
        @JvmStatic
        @JvmOverloads
        public fun explode(
            vertices: List<Point2>,
            spacing: Double,
            ratio: Double,
            distribution: Distribution = Distribution.LINEAR,
            rounding: Rounding = Rounding.NEAREST,
        ): DoubleArray = Lines(vertices, Traits(KIND, spacing, ratio, distribution, rounding)).explode()
    }
}
