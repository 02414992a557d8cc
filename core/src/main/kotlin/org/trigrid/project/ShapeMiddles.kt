package org.trigrid.project

import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.TriMesh
import org.trigrid.shape.MeasuredShape

/**
 * Middles of boundary edges on the curves that the boundary's nodes were made from: on the shape itself, to within rounding,
 * and halfway along it. Edges of straight shapes, of shapes with edited nodes and of no shape have straight middles.
 *
 * One object serves one mesh and those that are made of it by refining, as it remembers the nodes in the middles. Not for several
 * threads at once.
 *
 * @param path whose exploded nodes are nodes of the mesh, bit for bit.
 */
public class ShapeMiddles(path: Path) : EdgeMiddles {
    /** Places on curved shapes. */
    private val places = HashMap<Point2, MutableList<Place>>()

    /**
     * A place by the number of its node, a fraction for nodes that refining has made, and by its part of the shape's length.
     * Lengths alone would not tell which of the two ways round a closed shape is the shorter in nodes.
     */
    private class Place(val shape: MeasuredShape, val number: Double, val fraction: Double)

    init {
        for (number in 0 until path.shapeCount) {
            if (!path.isLinked(number)) continue
            val nodes = path.nodesOf(number)
            val shape = path.shape(number)
            val intervals = if (shape.isClosed()) nodes.size else nodes.size - 1
            val measured = if (intervals < 1) null else MeasuredShape.of(shape, intervals)
            if (measured == null) continue
            for ((i, node) in nodes.withIndex()) register(path.node(node), Place(measured, i.toDouble(), measured.fraction(i)))
        }
    }

    private fun register(point: Point2, place: Place) {
        places.getOrPut(point) { ArrayList(2) }.add(place)
    }

    override fun middleOf(mesh: TriMesh, edge: Int): DoubleArray {
        val begins = places[place(mesh, mesh.edgeStart(edge))] ?: return EdgeMiddles.STRAIGHT.middleOf(mesh, edge)
        val ends = places[place(mesh, mesh.edgeEnd(edge))] ?: return EdgeMiddles.STRAIGHT.middleOf(mesh, edge)
        for (a in begins) {
            val b = ends.firstOrNull { it.shape === a.shape } ?: continue
            val between = between(a, b)
            val middle = a.shape.place(between.fraction)
            register(middle, between)
            return doubleArrayOf(middle.x, middle.y)
        }
        return EdgeMiddles.STRAIGHT.middleOf(mesh, edge)
    }

    private fun place(mesh: TriMesh, node: Int) = Point2(mesh.x(node), mesh.y(node))

    private fun between(a: Place, b: Place): Place {
        val shape = a.shape
        val number = (a.number + b.number) / 2
        val fraction = (a.fraction + b.fraction) / 2
        val isRound = shape.isClosed && Math.abs(a.number - b.number) > shape.intervals / 2.0
        if (!isRound) return Place(shape, number, fraction)
        val isPast = fraction >= 0.5
        val half = shape.intervals / 2.0
        return Place(shape, if (number >= half) number - half else number + half, if (isPast) fraction - 0.5 else fraction + 0.5)
    }
}
