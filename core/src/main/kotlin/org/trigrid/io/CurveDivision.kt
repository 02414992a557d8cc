package org.trigrid.io

import java.io.Serializable

/** How the lines and curves of a file become boundary nodes. Immutable: the `with` functions return changed copies. */
public class CurveDivision private constructor(
    /** Wanted distance of neighbouring nodes, in the unit of the coordinates; NaN for the nodes of the file. */
    @get:JvmName("spacing") public val spacing: Double,
    /** Last spacing / first spacing of each line and curve, dimensionless; means nothing without a [spacing]. */
    @get:JvmName("ratio") public val ratio: Double,
    /**
     * In drawings of loose pieces (DXF) ends no farther from each other are one, in the unit of the file; NaN for a millionth of
     * the drawing's longer side.
     */
    @get:JvmName("join") public val join: Double,
    /** The unit of coordinates wanted where the file says its own; null for the file's. */
    @get:JvmName("unit") public val unit: LengthUnit?,
) : Serializable {
    /** Whether lines and curves are divided anew. */
    public fun hasSpacing(): Boolean = !spacing.isNaN()

    /** @throws IllegalArgumentException unless both are finite and > 0. */
    public fun withSpacing(spacing: Double, ratio: Double): CurveDivision {
        require(spacing > 0 && spacing < Double.POSITIVE_INFINITY) { "spacing must be a number above 0, not $spacing" }
        require(ratio > 0 && ratio < Double.POSITIVE_INFINITY) { "ratio must be a number above 0, not $ratio" }
        return CurveDivision(spacing, ratio, join, unit)
    }

    /** @throws IllegalArgumentException unless finite and >= 0. */
    public fun withJoin(value: Double): CurveDivision {
        require(value >= 0 && value < Double.POSITIVE_INFINITY) { "join must be a number of at least 0, not $value" }
        return CurveDivision(spacing, ratio, value, unit)
    }

    /** With [unit] set to [value]. */
    public fun withUnit(value: LengthUnit?): CurveDivision = CurveDivision(spacing, ratio, join, value)

    public companion object {
        /** Nodes of the file; curves divided by their bend. */
        @JvmField
        public val DEFAULT: CurveDivision = CurveDivision(Double.NaN, 1.0, Double.NaN, null)

        private const val serialVersionUID = 1L
    }
}
