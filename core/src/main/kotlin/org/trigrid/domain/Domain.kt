package org.trigrid.domain

/**
 * What is meshed: exact boundary nodes and the segments between them, the domain on the left of each.
 *
 * Nodes are numbered from 0 and each stands for one place; a node may have several segments
 * leaving it where loops touch. Segments come loop by loop; segment `s` runs from [segmentStart] to [segmentEnd].
 * An *embedded* segment has the domain on both of its sides and occurs once, in either direction, after all others. It may
 * part one region from another, and is an *interface* then. Nodes of no segment are embedded points and come last.
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
    tags: List<String>,
    internal val regionMap: DomainRegions,
    internal val points: DomainPoints = DomainPoints.NONE,
) {
    /** A domain of one region. */
    internal constructor(
        xy: DoubleArray, segments: IntArray, segmentTags: IntArray, embedded: BooleanArray, tags: List<String>, regionName: String,
    ) : this(xy, segments, segmentTags, embedded, tags, DomainRegions.single(Region.of(regionName)))

    /** The regions of the domain; most domains have one. */
    @get:JvmName("regions")
    public val regions: List<Region> get() = regionMap.list

    /** Name of the first region. */
    @get:JvmName("regionName")
    public val regionName: String get() = regions[0].name

    /** Names of boundary groups; each segment has one of them. */
    @get:JvmName("tags")
    public val tags: List<String> = java.util.List.copyOf(tags)

    /** How many segments bound the domain; the embedded ones come after them. */
    internal val boundaryCount: Int = embedded.count { !it }

    /** First segment of each loop, and [boundaryCount] at the end. */
    private val loopStarts: IntArray = DomainLoops(segments, boundaryCount).starts

    /** Boundary nodes, nodes of embedded segments, and embedded points. */
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    /** Boundary segments and embedded ones. */
    @get:JvmName("segmentCount")
    public val segmentCount: Int get() = segments.size / 2

    /** Closed loops of the boundary; an open chain of a faulty domain counts as one. */
    @get:JvmName("loopCount")
    public val loopCount: Int get() = loopStarts.size - 1

    /** In the unit of the coordinates, bit for bit as given. */
    public fun x(node: Int): Double = xy[2 * node]

    /** In the unit of the coordinates, bit for bit as given. */
    public fun y(node: Int): Double = xy[2 * node + 1]

    /** The node from which the segment runs. */
    public fun segmentStart(segment: Int): Int = segments[2 * segment]

    /** The node to which the segment runs. */
    public fun segmentEnd(segment: Int): Int = segments[2 * segment + 1]

    /** Length of a segment, in the unit of the coordinates. */
    public fun segmentLength(segment: Int): Double {
        val a = segmentStart(segment)
        val b = segmentEnd(segment)
        return Math.hypot(x(b) - x(a), y(b) - y(a))
    }

    /** Index into [tags] of the segment's group. */
    public fun segmentTag(segment: Int): Int = segmentTags[segment]

    /** Whether the domain lies on both sides of the segment. */
    public fun isEmbedded(segment: Int): Boolean = embedded[segment]

    /** Index into [regions] of the region on the left of the segment. */
    public fun regionOnLeft(segment: Int): Int = regionMap.left(segment)

    /** Index into [regions] of the region on the right of the segment; -1 if the segment bounds the domain. */
    public fun regionOnRight(segment: Int): Int = regionMap.right(segment, embedded[segment])

    /** Whether the segment parts two different regions. */
    public fun isInterface(segment: Int): Boolean = embedded[segment] && regionOnLeft(segment) != regionOnRight(segment)

    /** Points that were given to be nodes of the mesh; some may be ends of segments too. */
    @get:JvmName("pointCount")
    public val pointCount: Int get() = points.nodes.size

    /** The node of a point. */
    public fun pointNode(point: Int): Int = points.nodes[point]

    /** Index into [tags] of a point's group. */
    public fun pointTag(point: Int): Int = points.tags[point]

    /** Nodes that are ends of segments: they come before those that are not. */
    internal val segmentNodeCount: Int = 1 + (segments.maxOrNull() ?: -1)

    /** The domain without its embedded points of no segment; itself if there are none. */
    internal fun withoutLonePoints(): Domain {
        if (segmentNodeCount == nodeCount) return this
        return Domain(xy.copyOf(2 * segmentNodeCount), segments, segmentTags, embedded, tags, regionMap)
    }

    /** The loop's first segment; its others follow, up to the next loop's first. `loopStart(loopCount)` ends the last loop. */
    public fun loopStart(loop: Int): Int = loopStarts[loop]

    /** The loop's nodes in its direction, the domain on the left; the first is not repeated. */
    public fun loopNodes(loop: Int): IntArray =
        IntArray(loopStarts[loop + 1] - loopStarts[loop]) { segments[2 * (loopStarts[loop] + it)] }

    /** Whether the loop runs clockwise, that is, bounds a hole. */
    public fun isHole(loop: Int): Boolean = SignedArea.sign(xy, segments, loopStarts[loop], loopStarts[loop + 1]) < 0

    /** The area that is to be meshed, in the unit of the coordinates squared. */
    @get:JvmName("area")
    public val area: Double
        get() = (0 until loopCount).sumOf { SignedArea.twice(xy, segments, loopStarts[it], loopStarts[it + 1]) } / 2

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray = xy.copyOf()

    /**
     * The same outline with new nodes: each segment is a straight line whose length l is split into
     * n = max(1, round(l / [spacing])) intervals, their lengths in arithmetic progression along the segment. The nodes of this
     * domain's segments keep their places and numbers; embedded points of no segment come last.
     *
     * @param spacing wanted length of segments, in the unit of the coordinates.
     * @param ratio of a segment's last interval to its first; 1 for equal ones.
     * @throws org.trigrid.diagnostics.InvalidShapeException unless both are finite and above 0 and the nodes can be numbered.
     */
    public fun respaced(spacing: Double, ratio: Double): Domain = Respacing(this, spacing, ratio).respaced()

    /**
     * The same domain with lines and points embedded, and regions told. A hole in which the place of a region lies is filled.
     * Parts without such a place keep the region they have.
     * A region of the name of one of this domain takes its place with its material and largest size.
     */
    public fun with(inner: InnerParts): Domain {
        if (inner.isEmpty()) return this
        return withLinesAndPoints(inner.lines, inner.points).withRegions(inner.markers)
    }

    public companion object {
        /** Collects loops, holes and embedded lines. */
        @JvmStatic
        public fun builder(): DomainBuilder = DomainBuilder()

        /**
         * The domain of closed loops in any order and direction: which are holes is found out, all get the tag "boundary".
         *
         * @param loops each x0, y0, x1, y1, …, the first point not repeated; not modified.
         * @throws IllegalArgumentException if a loop has an odd number of values or none.
         */
        @JvmStatic
        public fun of(vararg loops: DoubleArray): Domain {
            val builder = DomainBuilder()
            for (loop in loops) builder.loop(loop)
            return builder.build()
        }
    }
}
