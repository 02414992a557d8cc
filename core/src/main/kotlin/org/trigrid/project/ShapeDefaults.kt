package org.trigrid.project

import org.trigrid.shape.Distribution
import org.trigrid.shape.Rounding
import org.trigrid.shape.Shape

/**
 * How shapes of a project are exploded unless they say otherwise; an editor gives these to new shapes. Immutable.
 *
 * @throws IllegalArgumentException unless spacing and ratio are numbers above 0.
 */
public class ShapeDefaults public constructor(
    /** In the domain's unit. */
    @get:JvmName("spacing") public val spacing: Double,
    @get:JvmName("ratio") public val ratio: Double,
    @get:JvmName("distribution") public val distribution: Distribution,
    @get:JvmName("rounding") public val rounding: Rounding,
) {
    init {
        require(spacing > 0 && spacing < Double.POSITIVE_INFINITY) { "spacing must be a number above 0, not $spacing" }
        require(ratio > 0 && ratio < Double.POSITIVE_INFINITY) { "ratio must be a number above 0, not $ratio" }
    }

    /** A shape with these settings in place of its own. */
    public fun applyTo(shape: Shape): Shape =
        shape.withSpacing(spacing).withRatio(ratio).withDistribution(distribution).withRounding(rounding)

    public companion object {
        /** Spacing 1, even intervals. */
        @JvmField
        public val STANDARD: ShapeDefaults = ShapeDefaults(1.0, 1.0, Distribution.LINEAR, Rounding.NEAREST)
    }
}
