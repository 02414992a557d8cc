package org.trigrid.geometry

/** An immutable point of the plane, for the API; meshing works on coordinate arrays. */
public class Point2(
    @get:JvmName("x") public val x: Double,
    @get:JvmName("y") public val y: Double,
) {
    /** Distance to [other], in the unit of the coordinates. */
    public fun distanceTo(other: Point2): Double = Math.hypot(other.x - x, other.y - y)

    /** Equal coordinates, compared as doubles are (`0.0` and `-0.0` differ, NaN equals NaN). */
    override fun equals(other: Any?): Boolean =
        other is Point2 && x.compareTo(other.x) == 0 && y.compareTo(other.y) == 0

    override fun hashCode(): Int = 31 * x.hashCode() + y.hashCode()

    override fun toString(): String = "($x, $y)"
}
