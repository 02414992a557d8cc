package org.trigrid.mesh

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
    /** Names of the edge groups. */
    @get:JvmName("tags") public val tags: List<String>,
    @get:JvmName("regionName") public val regionName: String,
) {
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    @get:JvmName("elementCount")
    public val elementCount: Int get() = elements.size / 3

    /** Boundary edges and embedded edges together. */
    @get:JvmName("taggedEdgeCount")
    public val taggedEdgeCount: Int get() = edges.size / 2

    public fun x(node: Int): Double = xy[2 * node]

    public fun y(node: Int): Double = xy[2 * node + 1]

    /** Node at [corner] 0..2 of [element]. */
    public fun nodeOf(element: Int, corner: Int): Int = elements[3 * element + corner]

    /** Element across [edge] 0..2 of [element], or [NONE] on the boundary. */
    public fun neighbourOf(element: Int, edge: Int): Int = neighbours[3 * element + edge]

    public fun kindOf(node: Int): NodeKind = NodeKind.of(kinds[node])

    public fun edgeStart(edge: Int): Int = edges[2 * edge]

    public fun edgeEnd(edge: Int): Int = edges[2 * edge + 1]

    /** Index into [tags] of a tagged edge. */
    public fun edgeTag(edge: Int): Int = edgeTags[edge]

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray = xy.copyOf()

    /** Three nodes an element, anticlockwise; a copy. */
    public fun elementNodes(): IntArray = elements.copyOf()

    /** Three elements an element, [NONE] on the boundary; a copy. */
    public fun elementNeighbours(): IntArray = neighbours.copyOf()

    /** Nodes on the edges of group [tag], ascending; for boundary conditions. Empty for an unknown name. */
    public fun nodesOn(tag: String): IntArray {
        val index = tags.indexOf(tag)
        val on = java.util.BitSet(nodeCount)
        for (e in edgeTags.indices) {
            if (edgeTags[e] == index) {
                on.set(edges[2 * e])
                on.set(edges[2 * e + 1])
            }
        }
        return on.stream().toArray()
    }

    public companion object {
        /** No element, no node. */
        public const val NONE: Int = -1
    }
}

/** How a node came into the mesh. */
public enum class NodeKind {
    /** Given, on the boundary; kept exactly. */
    BOUNDARY,

    /** Given, on an embedded line inside the domain; kept exactly. */
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
