package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A basic shape of the boundary, to be exploded into nodes. Immutable: the `with` functions return changed copies.
 *
 * Two shapes are equal when they are of one class with equal parameters.
 */
public sealed class Shape(
    internal val traits: Traits,
    /** Where the walk along the shape begins; the first node, exactly. */
    @get:JvmName("firstPoint") public val firstPoint: Point2,
    /** Where the walk along the shape ends; the last node, exactly. The first point where the shape is closed. */
    @get:JvmName("lastPoint") public val lastPoint: Point2,
) {
    /** Requested distance between neighbouring nodes, in the domain's unit, > 0. The mean one where the ratio is not 1. */
    @get:JvmName("spacing")
    public val spacing: Double get() = traits.spacing

    /** Last spacing / first spacing, > 0, dimensionless; middle / ends for [Distribution.SYMMETRIC]. */
    @get:JvmName("ratio")
    public val ratio: Double get() = traits.ratio

    /** How interval lengths run from the first to the last. */
    @get:JvmName("distribution")
    public val distribution: Distribution get() = traits.distribution

    /** How the number of intervals is made whole. */
    @get:JvmName("rounding")
    public val rounding: Rounding get() = traits.rounding

    /** Name of the boundary group (tag) that the shape's segments belong to; empty for the unnamed one. */
    @get:JvmName("name")
    public val name: String get() = traits.name

    /** Whether the shape ends where it begins. */
    public abstract fun isClosed(): Boolean

    /**
     * The shape's nodes with its own spacing and ratio: x0, y0, x1, y1, …, from [firstPoint] to [lastPoint] inclusive.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if the spacing asks for more than ten million nodes, or
     *   nodes would fall on one another.
     */
    public fun explode(): DoubleArray = explodeWith(traits)

    /** As [explode], with a given spacing and ratio in place of the shape's own. */
    public fun explode(spacing: Double, ratio: Double): DoubleArray = explodeWith(traits.spacing(spacing).ratio(ratio))

    internal abstract fun explodeWith(traits: Traits): DoubleArray

    /** The shape in its own direction, by arc length; null where it has straight sides. */
    internal open fun track(): Track? = null

    /** The same shape travelled the other way: it explodes to the same nodes in the opposite order, bit for bit. */
    public abstract fun reversed(): Shape

    /** @throws org.trigrid.diagnostics.InvalidShapeException unless a number above 0. */
    public abstract fun withSpacing(value: Double): Shape

    /** @throws org.trigrid.diagnostics.InvalidShapeException unless a number above 0. */
    public abstract fun withRatio(value: Double): Shape

    /** With [distribution] set to [value]. */
    public abstract fun withDistribution(value: Distribution): Shape

    /** With [rounding] set to [value]. */
    public abstract fun withRounding(value: Rounding): Shape

    /** @throws org.trigrid.diagnostics.InvalidShapeException if longer than 127 characters, with quotes or controls. */
    public abstract fun withName(value: String): Shape

    /** All that makes this shape differ from others of its class, traits apart. */
    internal abstract fun geometry(): List<Any>

    override fun equals(other: Any?): Boolean =
        other is Shape && other.javaClass == javaClass && other.traits.key() == traits.key() && other.geometry() == geometry()

    override fun hashCode(): Int = 31 * traits.key().hashCode() + geometry().hashCode()

    override fun toString(): String = buildString {
        append(traits.kind)
        if (name.isNotEmpty()) append(" \"").append(name).append('"')
        append(" from ").append(firstPoint)
        if (!isClosed()) append(" to ").append(lastPoint)
    }
}
