package org.trigrid.spacing

/** What the user lets sizes be at most, whatever the boundary. */
internal class SizeCeiling(
    private val maxSize: Double,
    private val userSizes: SampledSizes?,
    private val sources: SourceSizes?,
    /** Distance below which the ceiling may change; infinity where it is the same everywhere. */
    val detail: Double,
) {
    fun at(x: Double, y: Double): Double {
        var ceiling = maxSize
        if (userSizes != null) ceiling = Math.min(ceiling, userSizes.sizeAt(x, y))
        if (sources != null) ceiling = Math.min(ceiling, sources.sizeAt(x, y))
        return ceiling
    }
}
