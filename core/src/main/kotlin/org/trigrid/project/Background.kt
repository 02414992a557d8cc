package org.trigrid.project

import org.trigrid.geometry.Point2
import org.trigrid.shape.Similarity

/** A picture that a drawing is traced from, and where it lies. Immutable. */
public class Background(
    /**
     * The picture's file; relative to the folder of the project file, with `/` between names, unless it lies where no
     * relative path leads.
     */
    @get:JvmName("file") public val file: String,
    /** Where the picture's lower left corner lies, in the domain's unit. */
    @get:JvmName("lowerLeft") public val lowerLeft: Point2,
    /** Width of a pixel of the picture in the domain's unit, > 0. */
    @get:JvmName("pixelSize") public val pixelSize: Double,
    /** By how much the picture is turned about its lower left corner, anticlockwise. */
    @get:JvmName("rotationDegrees") public val rotationDegrees: Double,
    /** From 0, not seen, to 1. */
    @get:JvmName("opacity") public val opacity: Double,
    /** Whether the mouse leaves it where it is. */
    @get:JvmName("isLocked") public val isLocked: Boolean,
) {
    init {
        require(file.isNotEmpty()) { "the background needs a file" }
        require(lowerLeft.x.isFinite() && lowerLeft.y.isFinite()) { "lowerLeft must be numbers, not $lowerLeft" }
        require(pixelSize > 0 && pixelSize < Double.POSITIVE_INFINITY) { "pixelSize must be a number above 0, not $pixelSize" }
        require(rotationDegrees.isFinite()) { "rotationDegrees must be a number, not $rotationDegrees" }
        require(opacity in 0.0..1.0) { "opacity must be from 0 to 1, not $opacity" }
    }

    /** Takes the picture's pixels, x to the right and y upwards from its lower left corner, to the domain. */
    public fun placement(): Similarity = Similarity.scaling(ORIGIN, pixelSize)
        .then(Similarity.rotation(ORIGIN, rotationDegrees)).then(Similarity.translation(lowerLeft.x, lowerLeft.y))

    /** The same picture from another file. */
    public fun withFile(value: String): Background = Background(value, lowerLeft, pixelSize, rotationDegrees, opacity, isLocked)

    /** With its lower left corner elsewhere. */
    public fun withLowerLeft(value: Point2): Background = Background(file, value, pixelSize, rotationDegrees, opacity, isLocked)

    /** Turned about its lower left corner until its rotation is [value]. */
    public fun withRotationDegrees(value: Double): Background = Background(file, lowerLeft, pixelSize, value, opacity, isLocked)

    /** With another opacity, 0..1. */
    public fun withOpacity(value: Double): Background = Background(file, lowerLeft, pixelSize, rotationDegrees, value, isLocked)

    /** Locked or free. */
    public fun withLock(value: Boolean): Background = Background(file, lowerLeft, pixelSize, rotationDegrees, opacity, value)

    /** Made [factor] times as large, > 0, [centre] staying where it is. */
    public fun scaled(centre: Point2, factor: Double): Background {
        val corner = Similarity.scaling(centre, factor).apply(lowerLeft)
        return Background(file, corner, pixelSize * factor, rotationDegrees, opacity, isLocked)
    }

    /** Turned anticlockwise by [degrees] about [centre]. */
    public fun rotated(centre: Point2, degrees: Double): Background {
        val corner = Similarity.rotation(centre, degrees).apply(lowerLeft)
        return Background(file, corner, pixelSize, rotationDegrees + degrees, opacity, isLocked)
    }

    public companion object {
        /** Opacity of a background whose file does not say it. */
        public const val USUAL_OPACITY: Double = 0.5

        private val ORIGIN = Point2(0.0, 0.0)
    }
}
