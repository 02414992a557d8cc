package org.trigrid.spacing

/** What the user lets sizes be at most, whatever the boundary. */
internal class SizeCeiling(
    private val maxSize: Double,
    private val userSizes: SampledSizes?,
    private val sources: SourceSizes?,
    private val regions: RegionSizes?,
    /** Distance below which the ceiling may change; infinity where it is the same everywhere. */
    val detail: Double,
) {
    /** @param triangle of the domain's triangulation near the place, or -1. */
    fun at(x: Double, y: Double, triangle: Int): Double = lowest(x, y, regions?.at(x, y, triangle) ?: maxSize)

    /** At node [node] of the domain, where the finest of the regions that meet there rules. */
    fun atNode(node: Int, x: Double, y: Double): Double = lowest(x, y, regions?.atNode(node) ?: maxSize)

    private fun lowest(x: Double, y: Double, ofRegion: Double): Double {
        var ceiling = Math.min(maxSize, ofRegion)
        if (userSizes != null) ceiling = Math.min(ceiling, userSizes.sizeAt(x, y))
        if (sources != null) ceiling = Math.min(ceiling, sources.sizeAt(x, y))
        return ceiling
    }
}
