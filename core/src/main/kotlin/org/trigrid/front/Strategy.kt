package org.trigrid.front

/** The rules by which the front makes elements. */
public enum class Strategy {
    /** The paper's: smallest angle first, cases A, B and C, eq. (1). */
    CLASSIC,

    /** Short edges first, placement by the size field, best candidate of several. */
    ROBUST,
}
