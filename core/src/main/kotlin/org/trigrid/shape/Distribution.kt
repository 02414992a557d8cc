package org.trigrid.shape

/** How the lengths of a shape's intervals follow one another between the first and the last. */
public enum class Distribution {
    /** Arithmetic progression, each interval longer by the same amount: the paper's (appendix A). */
    LINEAR,

    /** Geometric progression, each interval longer by the same factor: what a ratio means in most meshers. */
    GEOMETRIC,

    /**
     * Alike from both ends to the middle, an arithmetic progression in each half; the ratio is that of the middle
     * spacing to the spacing at the ends, so above 1 both ends are fine. Turning the shape round changes nothing.
     */
    SYMMETRIC,
}
