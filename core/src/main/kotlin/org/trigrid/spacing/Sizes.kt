package org.trigrid.spacing

/** How element sizes vary away from the boundary. */
public enum class Sizes {
    /** From the spacing of one boundary to that of the other, smoothly; slope limited by the gradation. */
    SMOOTH,

    /** Growing from the boundary by the gradation, as far as the domain allows. */
    GRADE,
}
