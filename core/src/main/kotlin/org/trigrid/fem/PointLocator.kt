package org.trigrid.fem

import org.trigrid.domain.SegmentTree
import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.Predicates
import org.trigrid.mesh.TriMesh

/**
 * Finds the element at a place, in logarithmic time: a packed tree of the elements' boxes and exact predicates. Every place
 * of the mesh, its boundary included, is found in some element. Immutable, and free to be asked by several threads at once.
 */
public class PointLocator private constructor(
    @get:JvmName("mesh") public val mesh: TriMesh,
    /** Width or height of the mesh, whichever is more. */
    private val extent: Double,
) {
    private val elements = SegmentTree(boxCorners(mesh), IntArray(2 * mesh.elementCount) { it })

    /** Element and corner at which each boundary edge begins: 3 * element + corner. */
    private val rim: IntArray = mesh.neighbours.indices.filter { mesh.neighbours[it] < 0 }.toIntArray()
    private val rimEdges =
        SegmentTree(mesh.xy, IntArray(2 * rim.size) { mesh.elements[if (it % 2 == 0) rim[it / 2] else next(rim[it / 2])] })

    /**
     * The element that holds ([x], [y]): of several, at a node or on an edge, the one with the lowest number;
     * [TriMesh.NONE] outside of the mesh and for what is not a number.
     */
    public fun elementAt(x: Double, y: Double): Int {
        var found = TriMesh.NONE
        elements.forEachIn(x, y, x, y) { if ((found < 0 || it < found) && holds(it, x, y)) found = it }
        return found
    }

    /** The elements at many places, by [elementAt]. @param places x0, y0, x1, y1, …; not modified. */
    public fun elementsAt(places: DoubleArray): IntArray {
        require(places.size % 2 == 0) { "places are two numbers each, not ${places.size} numbers" }
        return IntArray(places.size / 2) { elementAt(places[2 * it], places[2 * it + 1]) }
    }

    /**
     * The place of the mesh that is nearest to ([x], [y]): the place itself inside, else the nearest of the boundary.
     *
     * @throws IllegalArgumentException if a coordinate is not a finite number or the mesh has no element.
     */
    public fun nearest(x: Double, y: Double): MeshPlace {
        require(Math.abs(x) <= Double.MAX_VALUE && Math.abs(y) <= Double.MAX_VALUE) { "($x, $y) is no place" }
        require(mesh.elementCount > 0) { "the mesh has no element" }
        val element = elementAt(x, y)
        if (element >= 0) return MeshPlace(element, x, y, 0.0)
        var reach = Math.max(1e-3 * extent, java.lang.Double.MIN_NORMAL)
        var best: MeshPlace? = null
        while (best == null) {
            best = nearestWithin(x, y, reach)
            reach *= 4
        }
        // The square searched holds the circle of its half side, and more: what was found need not be the nearest.
        return if (best.distance > reach / 4) nearestWithin(x, y, best.distance) ?: best else best
    }

    /** The nearest place on a boundary edge that touches the square of half side [reach], or null. */
    private fun nearestWithin(x: Double, y: Double, reach: Double): MeshPlace? {
        var best = -1
        var least = Double.POSITIVE_INFINITY
        rimEdges.forEachIn(x - reach, y - reach, x + reach, y + reach) {
            val t = along(it, x, y)
            val distance = Math.hypot(edgeX(it, t) - x, edgeY(it, t) - y)
            if (best < 0 || distance < least || distance == least && rim[it] < rim[best]) {
                least = distance
                best = it
            }
        }
        if (best < 0) return null
        val t = along(best, x, y)
        return MeshPlace(rim[best] / 3, edgeX(best, t), edgeY(best, t), least)
    }

    /** Where on a boundary edge the foot of the perpendicular lies: 0 at its start, 1 at its end, not beyond. */
    private fun along(edge: Int, x: Double, y: Double): Double {
        val a = mesh.elements[rim[edge]]
        val b = mesh.elements[next(rim[edge])]
        val dx = mesh.x(b) - mesh.x(a)
        val dy = mesh.y(b) - mesh.y(a)
        val t = ((x - mesh.x(a)) * dx + (y - mesh.y(a)) * dy) / (dx * dx + dy * dy)
        return Math.max(0.0, Math.min(1.0, t))
    }

    private fun edgeX(edge: Int, t: Double) =
        (1 - t) * mesh.x(mesh.elements[rim[edge]]) + t * mesh.x(mesh.elements[next(rim[edge])])

    private fun edgeY(edge: Int, t: Double) =
        (1 - t) * mesh.y(mesh.elements[rim[edge]]) + t * mesh.y(mesh.elements[next(rim[edge])])

    private fun holds(element: Int, x: Double, y: Double): Boolean {
        for (half in 3 * element..3 * element + 2) {
            val a = mesh.elements[half]
            val b = mesh.elements[next(half)]
            if (Predicates.orient(mesh.x(a), mesh.y(a), mesh.x(b), mesh.y(b), x, y) < 0) return false
        }
        return true
    }

    public companion object {
        /**
         * Linear in the size of the mesh, but for a sort; keep it for many questions.
         *
         * @throws IllegalArgumentException if a node's coordinate is not a finite number.
         */
        @JvmStatic
        public fun of(mesh: TriMesh): PointLocator {
            require(mesh.xy.all { Math.abs(it) <= Double.MAX_VALUE }) { "a node's coordinate is not a finite number" }
            return PointLocator(mesh, Math.max(extent(mesh.xy, 0), extent(mesh.xy, 1)))
        }

        private fun extent(xy: DoubleArray, axis: Int): Double {
            var min = Double.POSITIVE_INFINITY
            var max = Double.NEGATIVE_INFINITY
            for (i in axis until xy.size step 2) {
                min = Math.min(min, xy[i])
                max = Math.max(max, xy[i])
            }
            return max - min
        }

        /** Lower left and upper right corner of each element's box. */
        private fun boxCorners(mesh: TriMesh) = DoubleArray(4 * mesh.elementCount) { i ->
            val axis = i and 1
            val first = mesh.xy[2 * mesh.nodeOf(i / 4, 0) + axis]
            val second = mesh.xy[2 * mesh.nodeOf(i / 4, 1) + axis]
            val third = mesh.xy[2 * mesh.nodeOf(i / 4, 2) + axis]
            if (i and 2 == 0) Math.min(first, Math.min(second, third)) else Math.max(first, Math.max(second, third))
        }
    }
}
