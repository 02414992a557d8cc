package org.trigrid.spacing

import org.trigrid.geometry.Pose

/** What is asked of the sizes inside a domain. */
internal class SizeRules @JvmOverloads constructor(
    val sizes: Sizes,
    /** Largest slope of the size, size per length, > 0. */
    val gradation: Double,
    /** Smallest size asked of an inner edge, in the domain's unit; 0 for none. */
    val minSize: Double,
    /** Largest size asked of an inner edge, in the domain's unit; infinity for none. */
    val maxSize: Double,
    /** The user's sizes, or null. */
    val function: SizeFunction?,
    /** Points and lines with sizes of their own. */
    val sources: SizeSources = SizeSources.NONE,
    /** How the domain is laid to which the rules apply; function and sources speak of places as they were given. */
    val pose: Pose = Pose.AS_GIVEN,
)
