package org.trigrid.editor.document

import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Shape
import org.trigrid.shape.Similarity

/** A place by which a shape can be pulled into another one. */
internal class ShapeHandle(val point: Point2, val what: String, val dragged: (Point2) -> Shape)

/** The places by which shapes are pulled: their ends, corners, vertices and centres. */
internal object ShapeHandles {
    /** Those of a shape of [path]; a connector between two walks has none, since it goes where its nodes go. */
    fun of(path: Path, number: Int): List<ShapeHandle> = if (path.joinsWalks(number)) emptyList() else of(path.shape(number))

    fun of(shape: Shape): List<ShapeHandle> = when (shape) {
        is Line -> ends(shape) { a, b -> shape.withEnds(a, b) }
        is Arc -> ends(shape) { a, b -> shape.withEnds(a, b) } + bulge(shape)
        is Lines -> vertices(shape.vertices, shape.isClosed()) { shape.withVertices(it) }
        is Curve -> vertices(shape.vertices, false) { shape.withVertices(it) }
        is Polygon -> polygon(shape)
        is Rectangle -> rectangle(shape)
        is Circle -> listOf(
            ShapeHandle(shape.centre, "centre") { shape.withCentre(it) },
            ShapeHandle(shape.firstPoint, "first point") { shape.withFirstPoint(it) },
        )
        is Ellipse -> ellipse(shape)
    }

    private fun ends(shape: Shape, make: (Point2, Point2) -> Shape) = listOf(
        ShapeHandle(shape.firstPoint, "begin") { make(it, shape.lastPoint) },
        ShapeHandle(shape.lastPoint, "end") { make(shape.firstPoint, it) },
    )

    private fun bulge(arc: Arc): ShapeHandle {
        val nodes = arc.explode(arc.radius * Math.toRadians(Math.abs(arc.angleDegrees)) / 2, 1.0)
        val middle = if (nodes.size / 2 % 2 == 1) nodes.size / 4 else nodes.size / 4 - 1
        return ShapeHandle(Point2(nodes[2 * middle], nodes[2 * middle + 1]), "bulge") {
            arc.withAngleDegrees(Arc.through(arc.firstPoint, it, arc.lastPoint, arc.spacing).angleDegrees)
        }
    }

    private fun vertices(points: List<Point2>, isClosed: Boolean, make: (List<Point2>) -> Shape): List<ShapeHandle> {
        val count = if (isClosed) points.size - 1 else points.size
        return (0 until count).map { i ->
            ShapeHandle(points[i], "vertex ${i + 1}") { to ->
                val moved = points.replaced(i, to)
                make(if (isClosed && i == 0) moved.replaced(points.size - 1, to) else moved)
            }
        }
    }

    private fun polygon(shape: Polygon): List<ShapeHandle> {
        if (!shape.isRegular) {
            return vertices(shape.vertices, false) { Traited(shape).polygon(it) }
        }
        val centre = ShapeHandle(shape.centre, "centre") {
            Similarity.translation(it.x - shape.centre.x, it.y - shape.centre.y).apply(shape)
        }
        val first = ShapeHandle(shape.firstPoint, "first point") {
            Traited(shape).copyTo(Polygon(it, shape.centre, shape.vertices.size, shape.spacing).withDirection(shape.direction))
        }
        return listOf(centre, first)
    }

    private fun rectangle(shape: Rectangle): List<ShapeHandle> {
        val a = shape.firstPoint
        val b = shape.endCorner
        return listOf(
            ShapeHandle(a, "begin corner") { shape.withCorners(it, b) },
            ShapeHandle(b, "end corner") { shape.withCorners(a, it) },
            ShapeHandle(Point2(b.x, a.y), "corner") { shape.withCorners(Point2(a.x, it.y), Point2(it.x, b.y)) },
            ShapeHandle(Point2(a.x, b.y), "corner") { shape.withCorners(Point2(it.x, a.y), Point2(b.x, it.y)) },
        )
    }

    private fun ellipse(shape: Ellipse): List<ShapeHandle> {
        val turn = Similarity.rotation(shape.centre, shape.rotationDegrees)
        val back = Similarity.rotation(shape.centre, -shape.rotationDegrees)
        val c = shape.centre
        return listOf(
            ShapeHandle(c, "centre") { shape.withCentre(it) },
            ShapeHandle(turn.apply(Point2(c.x + shape.radiusX, c.y)), "radius x") {
                shape.withRadii(Math.abs(back.apply(it).x - c.x), shape.radiusY)
            },
            ShapeHandle(turn.apply(Point2(c.x, c.y + shape.radiusY)), "radius y") {
                shape.withRadii(shape.radiusX, Math.abs(back.apply(it).y - c.y))
            },
        )
    }
}

/** Gives the settings of one shape to another. */
internal class Traited(private val shape: Shape) {
    fun copyTo(other: Shape): Shape = other.withSpacing(shape.spacing).withRatio(shape.ratio)
        .withDistribution(shape.distribution).withRounding(shape.rounding).withName(shape.name)

    fun polygon(vertices: List<Point2>): Shape = copyTo(Polygon(vertices, shape.spacing))
}
