package org.trigrid.improve

/** How far surgery that mends the valences may lower the quality of the elements at hand before they are smoothed. */
internal object QualityGuard {
    /** Whether the least q may go from [before] to [after]: up, or down by no more than [share] and not below [floor]. */
    @JvmStatic
    fun allows(before: Double, after: Double, floor: Double, share: Double): Boolean =
        after > Star.SURELY_POSITIVE && (after >= before || (after > floor && after > share * before))
}
