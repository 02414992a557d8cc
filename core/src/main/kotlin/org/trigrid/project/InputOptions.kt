package org.trigrid.project

/** How the file of a domain becomes boundary nodes. Immutable: the `with` functions return changed copies. */
public class InputOptions private constructor(
    /** Distance of neighbouring boundary nodes that takes the place of the file's, in the domain's unit; NaN for the file's own. */
    @get:JvmName("spacing") public val spacing: Double,
    /** Last spacing / first spacing of each shape or edge, dimensionless; means nothing without a [spacing]. */
    @get:JvmName("ratio") public val ratio: Double,
    /** Whether the connectors of a path stay as lines inside the domain. */
    @get:JvmName("keepConnectors") public val keepConnectors: Boolean,
) {
    /** Whether the file's own spacings are replaced. */
    public fun hasSpacing(): Boolean = !spacing.isNaN()

    /**
     * Explodes every shape of a project, or every edge of a polygon file, with these.
     *
     * @throws IllegalArgumentException unless both are finite and > 0.
     */
    public fun withSpacing(spacing: Double, ratio: Double): InputOptions {
        require(spacing > 0 && spacing < Double.POSITIVE_INFINITY) { "spacing must be a number above 0, not $spacing" }
        require(ratio > 0 && ratio < Double.POSITIVE_INFINITY) { "ratio must be a number above 0, not $ratio" }
        return InputOptions(spacing, ratio, keepConnectors)
    }

    /** With [keepConnectors] set to [value]. */
    public fun withKeepConnectors(value: Boolean): InputOptions = InputOptions(spacing, ratio, value)

    public companion object {
        /** Nodes as the file has them, connectors dropped. */
        @JvmField
        public val DEFAULT: InputOptions = InputOptions(Double.NaN, 1.0, false)
    }
}
