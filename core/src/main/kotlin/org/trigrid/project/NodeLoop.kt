package org.trigrid.project

import java.util.Collections

/**
 * A closed loop of given nodes, without shapes. Immutable.
 *
 * Its direction does not matter: whether it bounds the domain from outside or is a hole follows from what lies in what.
 *
 * @throws IllegalArgumentException if [coordinates] come not in pairs, or [segmentTags] are not one for each.
 */
public class NodeLoop public constructor(coordinates: DoubleArray, segmentTags: List<String>) {
    private val xy = coordinates.copyOf()

    /** Tag of the segment from each node to the next. */
    @get:JvmName("segmentTags")
    public val segmentTags: List<String> = java.util.List.copyOf(segmentTags)

    init {
        require(xy.size % 2 == 0) { "coordinates come in pairs, but there are ${xy.size} values" }
        require(xy.size / 2 == segmentTags.size) { "${xy.size / 2} segments have ${segmentTags.size} tags" }
    }

    /** All segments with one tag. @param coordinates x0, y0, x1, y1, …; the first node is not repeated at the end. */
    public constructor(coordinates: DoubleArray, tag: String) :
        this(coordinates, Collections.nCopies(coordinates.size / 2, tag))

    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    public fun x(node: Int): Double = xy[2 * node]

    public fun y(node: Int): Double = xy[2 * node + 1]

    /** x0, y0, x1, y1, …; a copy. */
    public fun coordinates(): DoubleArray = xy.copyOf()
}
