package org.trigrid.project

import org.trigrid.domain.InnerParts
import org.trigrid.io.CurveDivision

/** How the file of a domain becomes boundary nodes. Immutable: the `with` functions return changed copies. */
public class InputOptions private constructor(
    /** How lines and curves are divided. */
    @get:JvmName("division") public val division: CurveDivision,
    /** Whether the connectors of a path stay as lines inside the domain. */
    @get:JvmName("keepConnectors") public val keepConnectors: Boolean,
    /** Lines, points and places of regions that every domain gets beside those of the file. */
    @get:JvmName("inner") public val inner: InnerParts,
    /** Whether all domains of a file become one, each a region of it. */
    @get:JvmName("join") public val join: Boolean,
) {
    /** Distance of neighbouring boundary nodes that takes the place of the file's, in the domain's unit; NaN for the file's own. */
    @get:JvmName("spacing")
    public val spacing: Double get() = division.spacing

    /** Last spacing / first spacing of each shape or edge, dimensionless; means nothing without a [spacing]. */
    @get:JvmName("ratio")
    public val ratio: Double get() = division.ratio

    /** Whether the file's own spacings are replaced. */
    public fun hasSpacing(): Boolean = division.hasSpacing()

    /**
     * Explodes every shape of a project, or every edge of a polygon file, with these.
     *
     * @throws IllegalArgumentException unless both are finite and > 0.
     */
    public fun withSpacing(spacing: Double, ratio: Double): InputOptions =
        withDivision(division.withSpacing(spacing, ratio))

    /** With [division] set to [value]. */
    public fun withDivision(value: CurveDivision): InputOptions = InputOptions(value, keepConnectors, inner, join)

    /** With [keepConnectors] set to [value]. */
    public fun withKeepConnectors(value: Boolean): InputOptions = InputOptions(division, value, inner, join)

    /** With [inner] set to [value]. */
    public fun withInner(value: InnerParts): InputOptions = InputOptions(division, keepConnectors, value, join)

    /** With [join] set to [value]. */
    public fun withJoin(value: Boolean): InputOptions = InputOptions(division, keepConnectors, inner, value)

    public companion object {
        /** Nodes as the file has them, connectors dropped, nothing added. */
        @JvmField
        public val DEFAULT: InputOptions = InputOptions(CurveDivision.DEFAULT, false, InnerParts.NONE, false)
    }
}
