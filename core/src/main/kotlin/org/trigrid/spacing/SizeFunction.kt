package org.trigrid.spacing

/** The user's wanted element sizes, in the domain's unit. Must be > 0; called a bounded number of times. */
public fun interface SizeFunction {
    /** Wanted edge length at ([x], [y]), in the domain's unit. */
    public fun sizeAt(x: Double, y: Double): Double
}
