package org.trigrid.spacing

/** The sizes that sources ask for, exactly, where a sampled function would miss their tips: a tree of cones for the points, each segment of the lines by its distance. */
internal class SourceSizes(
    places: List<DoubleArray>,
    sizes: DoubleArray,
    private val gradation: Double,
) {
    private val points: ConeTree?

    /** x and y of both ends, and the size, of each segment. */
    private val segments: DoubleArray

    init {
        val isPoint = places.map { it.size == 2 }
        val pointXy = places.filterIndexed { i, _ -> isPoint[i] }.flatMap { it.asList() }.toDoubleArray()
        val pointSizes = sizes.filterIndexed { i, _ -> isPoint[i] }.toDoubleArray()
        points = if (pointSizes.isEmpty()) null else ConeTree(pointXy, pointSizes, gradation)
        val found = ArrayList<Double>()
        for ((i, place) in places.withIndex()) {
            for (at in 0..place.size - 4 step 2) {
                for (k in 0..3) found.add(place[at + k])
                found.add(sizes[i])
            }
        }
        segments = found.toDoubleArray()
    }

    fun sizeAt(x: Double, y: Double): Double {
        var size = points?.min(x, y, points.winner, Double.POSITIVE_INFINITY) ?: Double.POSITIVE_INFINITY
        for (at in segments.indices step NUMBERS) {
            val ofSource = segments[at + 4]
            if (ofSource < size) size = Math.min(size, ofSource + gradation * distance(x, y, at))
        }
        return size
    }

    private fun distance(x: Double, y: Double, at: Int): Double {
        val dx = segments[at + 2] - segments[at]
        val dy = segments[at + 3] - segments[at + 1]
        val px = x - segments[at]
        val py = y - segments[at + 1]
        val square = dx * dx + dy * dy
        val t = if (square > 0) Math.min(1.0, Math.max(0.0, (px * dx + py * dy) / square)) else 0.0
        return StrictMath.hypot(px - t * dx, py - t * dy)
    }

    private companion object {
        const val NUMBERS = 5
    }
}
