package org.trigrid.spacing

import org.trigrid.geometry.Pose
import java.io.Serializable

/**
 * Places that ask for small elements: points and polylines, anywhere. At a source elements have its size, and from there sizes
 * grow with the distance by the gradation of the mesh: `min over sources i of (h_i + g d_i)`. They are ceilings beside the
 * boundary's sizes, and no node is put at a source.
 *
 * Segments of the boundary are never divided, and from one that is longer than the ceiling sizes fall by the gradation too:
 * segments of length s at a distance d keep a source from its size h if s - g d > h. Then make the boundary finer.
 *
 * Immutable: the `with` functions return changed copies.
 */
public class SizeSources private constructor(private val places: List<DoubleArray>, private val sizes: List<Double>) :
    Serializable {
    /** Points and lines together. */
    @get:JvmName("count")
    public val count: Int get() = sizes.size

    /** Edge length asked for at a source, in the domain's unit. */
    public fun sizeOf(source: Int): Double = sizes[source]

    /** x and y of a source that is a point; x0, y0, x1, y1, … of one that is a polyline. A copy. */
    public fun placeOf(source: Int): DoubleArray = places[source].copyOf()

    /**
     * With a point more.
     *
     * @throws IllegalArgumentException if a coordinate is not finite, or unless the size is finite and at least 1e-60.
     */
    public fun withPoint(size: Double, x: Double, y: Double): SizeSources = with(size, doubleArrayOf(x, y))

    /**
     * With a polyline more.
     *
     * @param coordinates x0, y0, x1, y1, … of at least two places; not modified.
     * @throws IllegalArgumentException if there are fewer, a coordinate is not finite, or unless the size is finite and at least 1e-60.
     */
    public fun withLine(size: Double, vararg coordinates: Double): SizeSources {
        require(coordinates.size >= 4 && coordinates.size % 2 == 0) {
            "a line of a size source has at least two places of x and y, not ${coordinates.size} numbers"
        }
        return with(size, coordinates.copyOf())
    }

    /** With all of [other] too. */
    public fun with(other: SizeSources): SizeSources = SizeSources(places + other.places, sizes + other.sizes)

    private fun with(size: Double, place: DoubleArray): SizeSources {
        require(size >= LEAST && size < Double.POSITIVE_INFINITY) { "the size of a size source must be a number of at least $LEAST, not $size" }
        for (c in place) require(c.isFinite()) { "a size source has a coordinate that is not a finite number: $c" }
        return SizeSources(places.plusElement(place), sizes + size)
    }

    /** The sizes with a [gradation] in a plane laid in a [pose]; null if there is no source. Not for several threads. */
    internal fun graded(gradation: Double, pose: Pose): SourceSizes? {
        if (count == 0) return null
        val laid = places.map { place ->
            DoubleArray(place.size) {
                val x = place[it - it % 2]
                val y = place[it - it % 2 + 1]
                if (it % 2 == 0) pose.x(x, y) else pose.y(x, y)
            }
        }
        return SourceSizes(laid, sizes.toDoubleArray(), gradation)
    }

    override fun toString(): String = "$count size sources"

    public companion object {
        /** No source. */
        @JvmField
        public val NONE: SizeSources = SizeSources(emptyList(), emptyList())

        /** That of segments: products of smaller lengths leave the range of numbers. */
        private const val LEAST = 1e-60

        private const val serialVersionUID = 1L
    }
}
