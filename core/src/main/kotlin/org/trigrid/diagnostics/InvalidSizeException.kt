package org.trigrid.diagnostics

/**
 * The user's size function gave a size that is not above 0, or no number, at a place of the domain.
 *
 * @param x the place, in the domain's coordinates.
 * @param y the place, in the domain's coordinates.
 * @param size what the function gave.
 */
public class InvalidSizeException(
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
    @get:JvmName("size") public val size: Double,
) : TriGridException("the size function gave $size at ($x, $y); a size must be above 0")
