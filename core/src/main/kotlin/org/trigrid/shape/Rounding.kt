package org.trigrid.shape

/** How a number of intervals is made from length / spacing, which is seldom a whole number. */
public enum class Rounding {
    /** The nearest whole number, at least 1: the mean interval is as near to the spacing as can be. */
    NEAREST,

    /** The spacing is a maximum: as few intervals as keep every one of them at or below it. */
    CEILING,
}
