package org.trigrid.domain

import java.io.Serializable

/**
 * What lies inside a domain beside its loops: lines and points that the mesh keeps as edges and nodes, and places that tell
 * which region the part round them belongs to. For [Domain.with]. Immutable: the `with` functions return changed copies.
 */
public class InnerParts private constructor(
    internal val lines: List<InnerLine>,
    internal val points: List<InnerPoint>,
    internal val markers: List<RegionMarker>,
) : Serializable {
    /** Lines, open and closed ones. */
    @get:JvmName("lineCount")
    public val lineCount: Int get() = lines.size

    /** Points that become nodes. */
    @get:JvmName("pointCount")
    public val pointCount: Int get() = points.size

    /** Places that tell regions; a region may have several. */
    @get:JvmName("markerCount")
    public val markerCount: Int get() = markers.size

    /** Whether there is nothing. */
    public fun isEmpty(): Boolean = lines.isEmpty() && points.isEmpty() && markers.isEmpty()

    /** Group of a line's edges. */
    public fun lineTag(line: Int): String = lines[line].tag

    /** x0, y0, x1, y1, … of a line; the first node of a closed one is not repeated. A copy. */
    public fun lineNodes(line: Int): DoubleArray = lines[line].xy.copyOf()

    /** Whether the line runs back to its first node. */
    public fun isClosed(line: Int): Boolean = lines[line].isClosed

    /** Group of a point. */
    public fun pointTag(point: Int): String = points[point].tag

    /** In the unit of the domain, as [pointY]. */
    public fun pointX(point: Int): Double = points[point].x

    /** In the unit of the domain, as [pointX]. */
    public fun pointY(point: Int): Double = points[point].y

    /** The region that a place tells. */
    public fun markerRegion(marker: Int): Region = markers[marker].region

    /** In the unit of the domain, as [markerY]. */
    public fun markerX(marker: Int): Double = markers[marker].x

    /** In the unit of the domain, as [markerX]. */
    public fun markerY(marker: Int): Double = markers[marker].y

    /**
     * With an open line more.
     *
     * @param coordinates x0, y0, x1, y1, … of two nodes or more; not modified.
     * @throws IllegalArgumentException if there are fewer, or an odd number of values.
     */
    public fun withLine(tag: String, vararg coordinates: Double): InnerParts {
        require(coordinates.size >= 4 && coordinates.size % 2 == 0) { "a line needs two nodes or more of x and y, not ${coordinates.size} values" }
        return InnerParts(lines + InnerLine(coordinates.copyOf(), tag, false), points, markers)
    }

    /**
     * With a closed line more.
     *
     * @param coordinates x0, y0, x1, y1, … of three nodes or more, the first not repeated; not modified.
     * @throws IllegalArgumentException if there are fewer, or an odd number of values.
     */
    public fun withLoop(tag: String, vararg coordinates: Double): InnerParts {
        require(coordinates.size >= 6 && coordinates.size % 2 == 0) { "a closed line needs three nodes or more of x and y, not ${coordinates.size} values" }
        return InnerParts(lines + InnerLine(coordinates.copyOf(), tag, true), points, markers)
    }

    /** With a point more. */
    public fun withPoint(tag: String, x: Double, y: Double): InnerParts = InnerParts(lines, points + InnerPoint(x, y, tag), markers)

    /**
     * With a place more that tells a region; see [DomainBuilder.region].
     *
     * @throws IllegalArgumentException if another region has the same name.
     */
    public fun withRegion(region: Region, x: Double, y: Double): InnerParts {
        val isNew = markers.all { it.region.name != region.name || it.region == region }
        require(isNew) { "there is another region called \"${region.name}\"" }
        return InnerParts(lines, points, markers + RegionMarker(x, y, region))
    }

    /**
     * With all of [other] too.
     *
     * @throws IllegalArgumentException if regions of one name differ.
     */
    public fun with(other: InnerParts): InnerParts =
        other.markers.fold(InnerParts(lines + other.lines, points + other.points, markers)) { all, m -> all.withRegion(m.region, m.x, m.y) }

    public companion object {
        private const val serialVersionUID = 1L

        /** Nothing. */
        @JvmField
        public val NONE: InnerParts = InnerParts(emptyList(), emptyList(), emptyList())

        /**
         * What lies inside a domain: its embedded segments as lines, its points, and a place in each part if it has several regions;
         * so that the domain's loops with these are the domain again.
         */
        @JvmStatic
        public fun of(domain: Domain): InnerParts {
            val points = List(domain.pointCount) {
                InnerPoint(domain.x(domain.pointNode(it)), domain.y(domain.pointNode(it)), domain.tags[domain.pointTag(it)])
            }
            val markers = if (domain.regions.size > 1) RegionPoints.of(domain) else emptyList()
            return InnerParts(InnerChains(domain).lines(), points, markers)
        }
    }
}

/** A line inside a domain. */
internal class InnerLine(val xy: DoubleArray, val tag: String, val isClosed: Boolean) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** A point inside a domain. */
internal class InnerPoint(val x: Double, val y: Double, val tag: String) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** A place that tells to which region the part of the domain round it belongs. */
internal class RegionMarker(val x: Double, val y: Double, val region: Region) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}
