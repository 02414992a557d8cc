package org.trigrid.shape

/** A shape in one direction of travel, measured by arc length. */
internal interface Track {
    /** Length from begin to end, > 0. */
    val length: Double

    /** Writes the point at [fraction] (0..1) of the length to xy[2 * index], xy[2 * index + 1]. */
    fun place(fraction: Double, xy: DoubleArray, index: Int)
}

/** Makes a shape's track, in the shape's own direction or against it. */
internal fun interface TrackMaker {
    fun make(forward: Boolean): Track
}

/**
 * Explodes tracks so that either direction of travel gives the same nodes, bit for bit.
 *
 * That is what lets two regions share an edge that each of them travels its own way. It is had by computing only one of
 * the two directions: the one whose intervals grow, and where they do not, the canonical one.
 */
internal object TrackExploder {
    /** @param canonical whether the shape's own direction is the one that is computed where the ratio does not decide. */
    fun explode(traits: Traits, canonical: Boolean, maker: TrackMaker): DoubleArray {
        val growth = growth(traits)
        val undirected = growth == 1.0 || traits.distribution == Distribution.SYMMETRIC
        val forward = if (undirected) canonical else traits.ratio > 1
        val track = maker.make(forward)
        val xy = place(track, Intervals.fractions(Intervals.count(track.length, traits, growth), growth, traits.distribution))
        if (!forward) reverse(xy)
        return checkDistinct(xy, traits)
    }

    /**
     * The ratio as one >= 1, the same double whether given as r or as the rounded 1 / r: r goes through two inversions,
     * 1 / r through one, and a third inversion always returns to the result of the first.
     */
    fun growth(traits: Traits): Double = when {
        traits.distribution == Distribution.SYMMETRIC -> traits.ratio
        traits.ratio > 1 -> 1 / (1 / traits.ratio)
        else -> 1 / traits.ratio
    }

    /** Where the [count] + 1 nodes of an exploded shape lie in its own direction, as parts of its length. */
    fun fractions(traits: Traits, count: Int): DoubleArray {
        val fractions = Intervals.fractions(count, growth(traits), traits.distribution)
        val isTurned = traits.distribution != Distribution.SYMMETRIC && traits.ratio < 1
        return if (isTurned) DoubleArray(count + 1) { 1 - fractions[count - it] } else fractions
    }

    private fun place(track: Track, fractions: DoubleArray): DoubleArray {
        val xy = DoubleArray(2 * fractions.size)
        for (k in fractions.indices) track.place(fractions[k], xy, k)
        return xy
    }

    /** Reverses the order of the points of [xy], in place. */
    fun reverse(xy: DoubleArray) {
        var low = 0
        var high = xy.size - 2
        while (low < high) {
            for (c in 0..1) {
                val value = xy[low + c]
                xy[low + c] = xy[high + c]
                xy[high + c] = value
            }
            low += 2
            high -= 2
        }
    }

    /** Refuses neighbours at one place: the intervals asked for are below the resolution of the coordinates. */
    fun checkDistinct(xy: DoubleArray, traits: Traits): DoubleArray {
        for (i in 2 until xy.size step 2) {
            if (xy[i] == xy[i - 2] && xy[i + 1] == xy[i - 1]) {
                val place = "(${xy[i]}, ${xy[i + 1]})"
                Traits.refuse(traits.kind, "spacing ${traits.spacing} and ratio ${traits.ratio} put two nodes at $place")
            }
        }
        return xy
    }
}
