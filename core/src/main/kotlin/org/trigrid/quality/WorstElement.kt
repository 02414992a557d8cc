package org.trigrid.quality

/** An element of low quality and where it is. */
public class WorstElement internal constructor(
    /** Number of the element, from 0. */
    @get:JvmName("element") public val element: Int,
    /** Shape quality, dimensionless, 1 for an equilateral triangle. */
    @get:JvmName("quality") public val quality: Double,
    /** Smallest angle, degrees. */
    @get:JvmName("minAngle") public val minAngle: Double,
    /** Centroid, in the domain's coordinates. */
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
) {
    override fun toString(): String = "element $element at ($x, $y): quality $quality, smallest angle $minAngle degrees"
}
