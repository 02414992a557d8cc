package org.trigrid.mesh

import java.util.BitSet
import org.trigrid.domain.Region

/**
 * A mesh of triangles with six nodes (second order), immutable.
 *
 * Nodes and elements are numbered from 0. The corners of an element run anticlockwise, and the nodes 3, 4 and 5 are in the
 * middles of its edges:
 * ```
 *            2
 *           / \
 *          5   4
 *         /     \
 *        0---3---1
 * ```
 * Inner edges are straight, with their node halfway. Edges of the boundary and of embedded lines may be curved; the Jacobian
 * is positive on the whole of every element, nowhere below a tenth of what it would be with straight edges. A mesh read from a
 * file is as the file has it; [leastJacobian] tells what it is.
 */
public class QuadraticMesh internal constructor(
    internal val xy: DoubleArray,
    /** 6 per element. */
    internal val elements: IntArray,
    /** 3 per tagged edge: start, end, middle; boundary edges with the domain on the left, then embedded edges. */
    internal val edges: IntArray,
    internal val edgeTags: IntArray,
    /** Tagged edges from this one on are embedded, not boundary. */
    @get:JvmName("boundaryEdgeCount") public val boundaryEdgeCount: Int,
    /** Names of the groups of edges and points. */
    @get:JvmName("tags") public val tags: List<String>,
    internal val parts: MeshParts,
    /** Tagged edges whose middle is not where it was asked to be but nearer to the straight one, as the element would have folded. */
    @get:JvmName("straightenedEdgeCount") public val straightenedEdgeCount: Int,
) {
    /** The regions that elements belong to; most meshes have one. */
    @get:JvmName("regions")
    public val regions: List<Region> get() = parts.regions

    /** Name of the first region. */
    @get:JvmName("regionName")
    public val regionName: String get() = regions[0].name

    /** Index into [regions] of the region of an element. */
    public fun regionOf(element: Int): Int = parts.regionOf(element)

    /** Points that were given to be nodes. */
    @get:JvmName("pointCount")
    public val pointCount: Int get() = parts.points.size

    /** The node of a point that was given. */
    public fun pointNode(point: Int): Int = parts.points[point]

    /** Index into [tags] of a point's group. */
    public fun pointTag(point: Int): Int = parts.pointTags[point]

    /** Corners and middles together. */
    @get:JvmName("nodeCount")
    public val nodeCount: Int get() = xy.size / 2

    @get:JvmName("elementCount")
    public val elementCount: Int get() = elements.size / NODES_PER_ELEMENT

    /** Boundary edges and embedded edges together. */
    @get:JvmName("taggedEdgeCount")
    public val taggedEdgeCount: Int get() = edges.size / NODES_PER_EDGE

    public fun x(node: Int): Double = xy[2 * node]

    public fun y(node: Int): Double = xy[2 * node + 1]

    /** Node of an element: its corners at [place] 0..2, the middles of its edges at 3..5. */
    public fun nodeOf(element: Int, place: Int): Int = elements[NODES_PER_ELEMENT * element + place]

    /** First node of a tagged edge. */
    public fun edgeStart(edge: Int): Int = edges[NODES_PER_EDGE * edge]

    /** Last node of a tagged edge. */
    public fun edgeEnd(edge: Int): Int = edges[NODES_PER_EDGE * edge + 1]

    /** Node in the middle of a tagged edge. */
    public fun edgeMiddle(edge: Int): Int = edges[NODES_PER_EDGE * edge + 2]

    /** Index into [tags] of a tagged edge. */
    public fun edgeTag(edge: Int): Int = edgeTags[edge]

    /** x0, y0, x1, y1, …; a copy. */
    public fun nodeCoordinates(): DoubleArray = xy.copyOf()

    /** Six nodes an element: corners anticlockwise, then middles; a copy. */
    public fun elementNodes(): IntArray = elements.copyOf()

    /** Largest difference of the numbers of two nodes of an element: the coefficient matrix' half-bandwidth B. */
    @get:JvmName("halfBandwidth")
    public val halfBandwidth: Int get() {
        var widest = 0
        for (first in elements.indices step NODES_PER_ELEMENT) {
            var low = elements[first]
            var high = low
            for (at in first + 1 until first + NODES_PER_ELEMENT) {
                low = minOf(low, elements[at])
                high = maxOf(high, elements[at])
            }
            widest = maxOf(widest, high - low)
        }
        return widest
    }

    /** Bandwidth of the coefficient matrix, 2 B + 1 by the paper's eqs. (6) to (10). */
    @get:JvmName("bandwidth")
    public val bandwidth: Int get() = 2 * halfBandwidth + 1

    /** Area of an element with its curved edges, in the square of the domain's unit. */
    public fun area(element: Int): Double = jacobian(element).area

    /**
     * The smallest Jacobian determinant on an element, over the unit triangle: twice the area for an element of straight edges.
     * The smallest of a quadratic polynomial, found exactly but for rounding.
     */
    public fun leastJacobian(element: Int): Double = jacobian(element).least()

    private fun jacobian(element: Int) = QuadraticJacobian(
        DoubleArray(2 * NODES_PER_ELEMENT) { xy[2 * elements[NODES_PER_ELEMENT * element + it / 2] + it % 2] },
    )

    /**
     * The same mesh with other node numbers. Elements come in the order of their lowest new corner.
     *
     * @param newNumbers size nodeCount, the new number of each node; not modified.
     * @throws IllegalArgumentException if that is no permutation of the node numbers.
     */
    public fun renumbered(newNumbers: IntArray): QuadraticMesh = MeshRenumbering.apply(this, newNumbers)

    /** Nodes on the edges of group [tag] and its points, middles too, ascending; for boundary conditions. Empty for an unknown name. */
    public fun nodesOn(tag: String): IntArray {
        val index = tags.indexOf(tag)
        val on = BitSet(nodeCount)
        for (at in edges.indices) if (edgeTags[at / NODES_PER_EDGE] == index) on.set(edges[at])
        for (p in parts.points.indices) if (parts.pointTags[p] == index) on.set(parts.points[p])
        return on.stream().toArray()
    }

    public companion object {
        internal const val NODES_PER_ELEMENT = 6
        internal const val NODES_PER_EDGE = 3

        /** As the other, with straight edges. */
        @JvmStatic
        public fun of(mesh: TriMesh): QuadraticMesh = of(mesh, EdgeMiddles.STRAIGHT)

        /**
         * The mesh with a node in the middle of each edge. The nodes keep their numbers, the new ones come after them: renumber
         * with `Numbering.renumber`, or let `MeshRework.secondOrder` do both.
         *
         * @param middles where the middles of tagged edges are to lie; those of others lie halfway. A middle that would fold an
         *   element is moved towards the straight one, see [straightenedEdgeCount].
         * @throws IllegalArgumentException if [mesh] is not valid by [MeshCheck].
         */
        @JvmStatic
        public fun of(mesh: TriMesh, middles: EdgeMiddles): QuadraticMesh {
            MeshCheck.requireValid(mesh)
            return QuadraticElements(mesh, middles).make()
        }
    }
}
