package org.trigrid.shape

/** What a spline does at its ends. */
public enum class CurveEnds {
    /** No curvature at the ends. */
    NATURAL,

    /** Leaves and arrives in given directions. */
    CLAMPED,

    /** Goes on smoothly from the last vertex to the first. */
    CLOSED,
}
