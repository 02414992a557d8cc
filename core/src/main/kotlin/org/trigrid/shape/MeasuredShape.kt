package org.trigrid.shape

import org.trigrid.geometry.Point2

/** A curved shape by arc length, with the places of its nodes. */
internal class MeasuredShape private constructor(shape: Shape, private val track: Track, val intervals: Int) {
    val isClosed: Boolean = shape.isClosed()
    private val fractions = TrackExploder.fractions(shape.traits, intervals)

    /** Where the node numbered [node] along the shape lies, as a part of the shape's length. */
    fun fraction(node: Int): Double = fractions[node]

    /** The point at [fraction] of the length. */
    fun place(fraction: Double): Point2 {
        val xy = DoubleArray(2)
        track.place(fraction, xy, 0)
        return Point2(xy[0], xy[1])
    }

    companion object {
        /** Null for a shape of straight sides. */
        fun of(shape: Shape, intervals: Int): MeasuredShape? = shape.track()?.let { MeasuredShape(shape, it, intervals) }
    }
}
