package org.trigrid.domain

/**
 * What is meshed: exact boundary nodes and the segments between them, the domain on the left of each.
 *
 * Nodes are numbered from 0 and each stands for one place; a node may have several segments
 * leaving it where loops touch. Segments come loop by loop; segment `s` runs from [segmentStart] to [segmentEnd].
 * An *embedded* segment has the domain on both of its sides and occurs once, in either direction.
 *
 * Immutable. A domain may still be faulty: [DomainCheck] finds all faults, meshing refuses a faulty one.
 */
public class Domain internal constructor(
    internal val xy: DoubleArray,
    /** 2 per segment: start node, end node. Not modified. */
    internal val segments: IntArray,
    /** Per segment: index into [tags]. */
    internal val segmentTags: IntArray,
    /** Per segment: whether the domain lies on both sides. */
    internal val embedded: BooleanArray,
    /** Names of boundary groups; each segment has one of them. */
    @get:JvmName("tags") public val tags: List<String>,
    /** Name of the meshed region; a physical group of the mesh file. */
    @get:JvmName("regionName") public val regionName: String,
) {
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    @get:JvmName("segmentCount")
    public val segmentCount: Int get() = segments.size / 2

    public fun x(node: Int): Double = xy[2 * node]

    public fun y(node: Int): Double = xy[2 * node + 1]

    public fun segmentStart(segment: Int): Int = segments[2 * segment]

    public fun segmentEnd(segment: Int): Int = segments[2 * segment + 1]

    /** Index into [tags] of the segment's group. */
    public fun segmentTag(segment: Int): Int = segmentTags[segment]

    public fun isEmbedded(segment: Int): Boolean = embedded[segment]

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray = xy.copyOf()
}
