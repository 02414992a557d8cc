package org.trigrid.project

import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.TriMesh
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Shape

/**
 * Middles of boundary edges on the curves that the boundary's nodes were made from: on the shape itself, to within rounding,
 * and within a hundredth of the edge's length of its middle. Edges of straight shapes, of shapes with edited nodes and of no shape have
 * straight middles.
 *
 * One object serves one mesh and those that are made of it by refining, as it remembers the nodes in the middles. Not for several
 * threads at once.
 *
 * @param path whose exploded nodes are nodes of the mesh, bit for bit.
 */
public class ShapeMiddles(path: Path) : EdgeMiddles {
    /** Places on curved shapes. */
    private val places = HashMap<Point2, MutableList<Place>>()

    private class Place(val curve: DenseCurve, val fraction: Double)

    init {
        for (number in 0 until path.shapeCount) {
            val shape = path.shape(number)
            if (!isCurved(shape) || !path.isLinked(number)) continue
            val nodes = path.nodesOf(number)
            val intervals = if (shape.isClosed()) nodes.size else nodes.size - 1
            if (intervals < 1) continue
            val curve = DenseCurve(shape)
            for ((i, node) in nodes.withIndex()) register(path.node(node), Place(curve, i.toDouble() / intervals))
        }
    }

    private fun isCurved(shape: Shape) = shape is Arc || shape is Circle || shape is Curve || shape is Ellipse

    private fun register(point: Point2, place: Place) {
        places.getOrPut(point) { ArrayList(2) }.add(place)
    }

    override fun middleOf(mesh: TriMesh, edge: Int): DoubleArray {
        val straight = EdgeMiddles.STRAIGHT.middleOf(mesh, edge)
        val begins = places[place(mesh, mesh.edgeStart(edge))] ?: return straight
        val ends = places[place(mesh, mesh.edgeEnd(edge))] ?: return straight
        for (a in begins) {
            val b = ends.firstOrNull { it.curve === a.curve } ?: continue
            val index = a.curve.nearest(a.fraction, b.fraction, straight[0], straight[1])
            val middle = Point2(a.curve.xy[2 * index], a.curve.xy[2 * index + 1])
            register(middle, Place(a.curve, a.curve.fraction(index)))
            return doubleArrayOf(middle.x, middle.y)
        }
        return straight
    }

    private fun place(mesh: TriMesh, node: Int) = Point2(mesh.x(node), mesh.y(node))

    /** Many points along a shape, spaced like its nodes. */
    private class DenseCurve(shape: Shape) {
        private val isClosed = shape.isClosed()
        val xy: DoubleArray = shape.explode(shape.spacing / DENSITY, shape.ratio)
        private val last = xy.size / 2 - 1

        fun fraction(index: Int) = index.toDouble() / last

        /** The point nearest to (x, y) of those between two fractions of the way, going round the shorter way where that is possible. */
        fun nearest(from: Double, to: Double, x: Double, y: Double): Int {
            var low = minOf(from, to)
            var high = maxOf(from, to)
            if (isClosed && high - low > 0.5) {
                val above = low + 1
                low = high
                high = above
            }
            var best = 0
            var nearest = Double.POSITIVE_INFINITY
            for (i in Math.floor(low * last).toInt() - DENSITY..Math.ceil(high * last).toInt() + DENSITY) {
                val index = if (isClosed) Math.floorMod(i, last) else i.coerceIn(0, last)
                val dx = xy[2 * index] - x
                val dy = xy[2 * index + 1] - y
                if (dx * dx + dy * dy >= nearest) continue
                nearest = dx * dx + dy * dy
                best = index
            }
            return best
        }
    }

    private companion object {
        /** Points of a dense curve to each node. */
        const val DENSITY = 64
    }
}
