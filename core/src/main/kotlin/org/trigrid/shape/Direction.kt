package org.trigrid.shape

/**
 * The way round a closed shape is travelled, x to the right and y up.
 *
 * Travelled as the outer boundary is, a shape is included in the domain; travelled against it, it is left out.
 */
public enum class Direction {
    /** As the hands of a clock turn. */
    CLOCKWISE,
    /** Against the hands of a clock. */
    ANTICLOCKWISE,
    ;

    /** The other way round. */
    public fun opposite(): Direction = if (this == CLOCKWISE) ANTICLOCKWISE else CLOCKWISE

    /** +1 for anticlockwise, -1 for clockwise. */
    internal val sign: Int get() = if (this == ANTICLOCKWISE) 1 else -1
}
