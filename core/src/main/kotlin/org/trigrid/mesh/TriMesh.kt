package org.trigrid.mesh

import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import java.util.BitSet

/**
 * A triangular mesh, immutable.
 *
 * Nodes and elements are numbered from 0. The corners of an element run anticlockwise; its edge `k` joins corner `k`
 * and corner `(k + 1) mod 3`:
 * ```
 *            2
 *           / \
 *   edge 2 /   \ edge 1
 *         /     \
 *        0-------1
 *          edge 0
 * ```
 */
public class TriMesh internal constructor(
    internal val xy: DoubleArray,
    internal val elements: IntArray,
    internal val neighbours: IntArray,
    internal val kinds: ByteArray,
    /** 2 per tagged edge: boundary edges with the domain on the left, then embedded edges. */
    internal val edges: IntArray,
    internal val edgeTags: IntArray,
    /** Tagged edges from this one on are embedded, not boundary. */
    @get:JvmName("boundaryEdgeCount") public val boundaryEdgeCount: Int,
    /** Names of the groups of edges and points. */
    @get:JvmName("tags") public val tags: List<String>,
    internal val parts: MeshParts,
) {
    /** A mesh of one region. */
    internal constructor(
        xy: DoubleArray, elements: IntArray, neighbours: IntArray, kinds: ByteArray, edges: IntArray, edgeTags: IntArray,
        boundaryEdgeCount: Int, tags: List<String>, regionName: String,
    ) : this(xy, elements, neighbours, kinds, edges, edgeTags, boundaryEdgeCount, tags, MeshParts.single(regionName))

    /** The regions that elements belong to; most meshes have one. */
    @get:JvmName("regions")
    public val regions: List<Region> get() = parts.regions

    /** Name of the first region. */
    @get:JvmName("regionName")
    public val regionName: String get() = regions[0].name

    /** Points that were given to be nodes. */
    @get:JvmName("pointCount")
    public val pointCount: Int get() = parts.points.size

    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    @get:JvmName("elementCount")
    public val elementCount: Int get() = elements.size / 3

    /** Boundary edges and embedded edges together. */
    @get:JvmName("taggedEdgeCount")
    public val taggedEdgeCount: Int get() = edges.size / 2

    /** Nodes of kind [NodeKind.BOUNDARY]. */
    @get:JvmName("boundaryNodeCount")
    public val boundaryNodeCount: Int get() = kinds.count { it == NodeKind.BOUNDARY.code }

    public fun x(node: Int): Double = xy[2 * node]

    public fun y(node: Int): Double = xy[2 * node + 1]

    /** Node at [corner] 0..2 of [element]. */
    public fun nodeOf(element: Int, corner: Int): Int = elements[3 * element + corner]

    /** Element across [edge] 0..2 of [element], or [NONE] on the boundary. */
    public fun neighbourOf(element: Int, edge: Int): Int = neighbours[3 * element + edge]

    /** Where [node] came from. */
    public fun kindOf(node: Int): NodeKind = NodeKind.of(kinds[node])

    /** First node of a tagged edge. */
    public fun edgeStart(edge: Int): Int = edges[2 * edge]

    /** Second node of a tagged edge. */
    public fun edgeEnd(edge: Int): Int = edges[2 * edge + 1]

    /** Index into [tags] of a tagged edge. */
    public fun edgeTag(edge: Int): Int = edgeTags[edge]

    /** Index into [regions] of the region of an element. */
    public fun regionOf(element: Int): Int = parts.regionOf(element)

    /** Elements of the region called [name], ascending. Empty for an unknown name. */
    public fun elementsIn(name: String): IntArray {
        val region = regions.indexOfFirst { it.name == name }
        return (0 until elementCount).filter { regionOf(it) == region }.toIntArray()
    }

    /** The node of a point that was given. */
    public fun pointNode(point: Int): Int = parts.points[point]

    /** Index into [tags] of a point's group. */
    public fun pointTag(point: Int): Int = parts.pointTags[point]

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray = xy.copyOf()

    /** Three nodes an element, anticlockwise; a copy. */
    public fun elementNodes(): IntArray = elements.copyOf()

    /** Three elements an element, [NONE] on the boundary; a copy. */
    public fun elementNeighbours(): IntArray = neighbours.copyOf()

    /** Edges of the mesh, inner ones and those on the boundary. */
    @get:JvmName("edgeCount")
    public val edgeCount: Int get() {
        var boundary = 0
        for (n in neighbours) if (n < 0) boundary++
        return (elements.size + boundary) / 2
    }

    /** Every edge once, 2 nodes each, the lower number first; size 2 * [edgeCount]. A new array. */
    public fun edgeNodes(): IntArray = MeshTopology.edges(elements, neighbours)

    /** Largest difference of the numbers of two nodes of an element: the coefficient matrix' half-bandwidth B. */
    @get:JvmName("halfBandwidth")
    public val halfBandwidth: Int get() {
        var widest = 0
        for (at in elements.indices step 3) {
            val a = elements[at]
            val b = elements[at + 1]
            val c = elements[at + 2]
            widest = maxOf(widest, maxOf(a, maxOf(b, c)) - minOf(a, minOf(b, c)))
        }
        return widest
    }

    /** Bandwidth of the coefficient matrix, 2 B + 1 by the paper's eqs. (6) to (10). */
    @get:JvmName("bandwidth")
    public val bandwidth: Int get() = 2 * halfBandwidth + 1

    /** Area of an element, in the square of the domain's unit. */
    public fun area(element: Int): Double {
        val a = 2 * elements[3 * element]
        val b = 2 * elements[3 * element + 1]
        val c = 2 * elements[3 * element + 2]
        return 0.5 * ((xy[b] - xy[a]) * (xy[c + 1] - xy[a + 1]) - (xy[b + 1] - xy[a + 1]) * (xy[c] - xy[a]))
    }

    /**
     * The same mesh with other node numbers. Elements come in the order of their lowest new node, so that nodes and
     * elements that are near each other in memory are near each other in the domain.
     *
     * @param newNumbers size nodeCount, the new number of each node; not modified.
     * @throws IllegalArgumentException if that is no permutation of the node numbers.
     */
    public fun renumbered(newNumbers: IntArray): TriMesh = MeshRenumbering.apply(this, newNumbers)

    /** The domain that the mesh fills: its boundary edges as loops, its embedded edges and points, with tags and regions. */
    public fun outline(): Domain = MeshOutline.of(this)

    /**
     * Numbers of the tagged edges of group [tag], ascending; for loads along a boundary. Empty for an unknown name.
     *
     * @sample org.trigrid.samples.HeatInMachinePart.addFilm
     */
    public fun edgesOn(tag: String): IntArray {
        val index = tags.indexOf(tag)
        return edgeTags.indices.filter { edgeTags[it] == index }.toIntArray()
    }

    /** Nodes on the edges of group [tag] and its points, ascending; for boundary conditions. Empty for an unknown name. */
    public fun nodesOn(tag: String): IntArray {
        val index = tags.indexOf(tag)
        val on = BitSet(nodeCount)
        for (e in edgeTags.indices) {
            if (edgeTags[e] == index) {
                on.set(edges[2 * e])
                on.set(edges[2 * e + 1])
            }
        }
        for (p in parts.points.indices) if (parts.pointTags[p] == index) on.set(parts.points[p])
        return on.stream().toArray()
    }

    public companion object {
        /** No element, no node. */
        public const val NONE: Int = -1

        /**
         * A mesh of plain arrays. Every boundary edge gets the tag `boundary`; clockwise elements are turned.
         *
         * @param xy x0, y0, x1, y1, …; not modified.
         * @param elements three nodes an element, numbered from 0; not modified.
         * @throws IllegalArgumentException if an array has a wrong size or a node number is out of range.
         */
        @JvmStatic
        public fun of(xy: DoubleArray, elements: IntArray): TriMesh =
            TriMeshFactory.of(xy.copyOf(), elements.copyOf(), IntArray(0), IntArray(0), emptyList(), Region.DEFAULT_NAME)

        /**
         * As the other, with a region for each element. An edge between two regions gets the tag `interface`.
         *
         * @param regions the regions that elements may be in.
         * @param elementRegions per element the index of its region; not modified.
         * @throws IllegalArgumentException if a number is out of range or the arrays do not fit, or there is no region.
         */
        @JvmStatic
        public fun of(xy: DoubleArray, elements: IntArray, regions: List<Region>, elementRegions: IntArray): TriMesh {
            require(regions.isNotEmpty()) { "there are no regions" }
            require(elementRegions.size == elements.size / 3) { "${elements.size / 3} elements have ${elementRegions.size} regions" }
            for (r in elementRegions) require(r in regions.indices) { "region $r is not among the ${regions.size} given" }
            val parts = MeshParts(java.util.List.copyOf(regions), elementRegions.copyOf(), IntArray(0), IntArray(0))
            return TriMeshFactory.of(xy.copyOf(), elements.copyOf(), IntArray(0), IntArray(0), emptyList(), parts)
        }
    }
}

/** How a node came into the mesh. */
public enum class NodeKind {
    /** Given, on the boundary; kept exactly. */
    BOUNDARY,

    /** Given, on an embedded line or as an embedded point inside the domain; kept exactly. */
    EMBEDDED,

    /** Made by the mesher. */
    INTERIOR,
    ;

    internal val code: Byte get() = ordinal.toByte()

    internal companion object {
        private val all = entries.toTypedArray()

        fun of(code: Byte): NodeKind = all[code.toInt()]
    }
}
