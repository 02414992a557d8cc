package org.trigrid.editor.document

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.CurveEnds
import org.trigrid.shape.Direction
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Shape
import org.trigrid.shape.Similarity

/** Changes of a path's shapes as people mean them: what hangs together stays together. */
internal object ShapeEdits {
    /**
     * Appends a shape. One that ends where a walk is open goes on with it; a closed one elsewhere hangs on the open walk
     * by a connector, against the walk's direction, so that it is left out; where the walk is closed a new loop begins.
     */
    fun append(path: Path, shape: Shape): Path {
        val end = path.end() ?: return path.append(shape)
        val isConnectorEnd = path.shapeCount > 0 && path.isConnector(path.shapeCount - 1) && isAt(shape.firstPoint, end)
        return when {
            isConnectorEnd && shape.isClosed() -> path.append(against(path, shape)).back()
            isWalkOpen(path) && isAt(shape.firstPoint, end) -> path.append(shape)
            isWalkOpen(path) && shape.isClosed() ->
                path.appendOpening(Line(end, shape.firstPoint, shape.spacing), against(path, shape))
            isWalkOpen(path) -> path.append(shape)
            else -> path.newLoop().append(shape)
        }
    }

    /** Whether the last walk waits for more. */
    fun isWalkOpen(path: Path): Boolean = path.walks().lastOrNull()?.isClosed == false

    /** Where the last walk began, if it is open. */
    fun openStart(path: Path): Point2? {
        val walk = path.walks().lastOrNull()?.takeIf { !it.isClosed } ?: return null
        return path.node(walk.nodes().first())
    }

    /** Another shape in place of one; the ends of its neighbours, and what hangs on it, follow its ends. */
    fun replace(path: Path, shape: Int, by: Shape): Path = replace(path, mapOf(shape to by))

    /** Several shapes changed at once; others follow the ends of those. */
    fun transform(path: Path, shapes: Set<Int>, similarity: Similarity): Path =
        replace(path, shapes.associateWith { similarity.apply(path.shape(it)) })

    /**
     * From the last shape to the first, since with the edits of a shape's nodes a connector may go that was made at one of
     * them; it comes after the shape, so those before it keep their numbers.
     */
    private fun replace(path: Path, by: Map<Int, Shape>): Path {
        var changed = path
        for (other in path.shapeCount - 1 downTo 0) {
            val old = path.shape(other)
            val new = by[other] ?: by.entries.fold(old) { follower, (shape, moved) -> follow(follower, path.shape(shape), moved) }
            val isThere = other < changed.shapeCount && changed.shape(other) == old
            if (isThere && (other in by || new !== old)) changed = changed.replaceShape(other, new)
        }
        return changed
    }

    /** The same shape travelled the other way round from the same first point. */
    fun turnedRound(shape: Shape): Shape = when (shape) {
        is Rectangle -> shape.withDirection(shape.direction.opposite())
        is Polygon -> shape.withDirection(shape.direction.opposite())
        is Circle -> shape.withDirection(shape.direction.opposite())
        is Ellipse -> shape.withDirection(shape.direction.opposite())
        is Line, is Lines, is Curve, is Arc -> shape.reversed()
    }

    /** [shape], which is not closed, with its end elsewhere; null if there is no such shape. */
    fun endedAt(shape: Shape, end: Point2): Shape? = try {
        withEnds(shape, shape.firstPoint, end)
    } catch (_: InvalidShapeException) {
        null
    }

    /** [shape] with its ends moved where they lay on ends of [old]; the same object if they did not. */
    private fun follow(shape: Shape, old: Shape, by: Shape): Shape {
        val first = target(shape.firstPoint, old, by)
        val last = target(shape.lastPoint, old, by)
        if (first == shape.firstPoint && last == shape.lastPoint) return shape
        return try {
            withEnds(shape, first, last)
        } catch (_: InvalidShapeException) {
            shape
        }
    }

    private fun target(point: Point2, old: Shape, by: Shape): Point2 = when {
        isAt(point, old.lastPoint) -> by.lastPoint
        isAt(point, old.firstPoint) -> by.firstPoint
        else -> point
    }

    private fun withEnds(shape: Shape, first: Point2, last: Point2): Shape = when (shape) {
        is Line -> shape.withEnds(first, last)
        is Arc -> shape.withEnds(first, last)
        is Lines -> shape.withVertices(listOf(first) + shape.vertices.subList(1, shape.vertices.size - 1) + last)
        is Curve -> if (shape.ends == CurveEnds.CLOSED) {
            shifted(shape, first)
        } else {
            shape.withVertices(listOf(first) + shape.vertices.subList(1, shape.vertices.size - 1) + last)
        }
        is Rectangle, is Polygon, is Circle, is Ellipse -> shifted(shape, first)
    }

    private fun shifted(shape: Shape, first: Point2): Shape =
        Similarity.translation(first.x - shape.firstPoint.x, first.y - shape.firstPoint.y).apply(shape)

    /** [shape] in the direction that leaves it out of what the last walk bounds. */
    private fun against(path: Path, shape: Shape): Shape {
        val direction = directionOf(shape) ?: return shape
        return if (direction == directionOfWalk(path)) turnedRound(shape) else shape
    }

    private fun directionOf(shape: Shape): Direction? = when (shape) {
        is Rectangle -> shape.direction
        is Polygon -> shape.direction
        is Circle -> shape.direction
        is Ellipse -> shape.direction
        is Curve -> Polygon(shape.vertices, shape.spacing).direction
        is Line, is Lines, is Arc -> null
    }

    private fun directionOfWalk(path: Path): Direction = try {
        val walk = path.walks().last().nodes().map { path.node(it) }
        Polygon(walk, 1.0).direction
    } catch (_: InvalidShapeException) {
        Direction.ANTICLOCKWISE
    }

    fun isAt(a: Point2, b: Point2): Boolean = a.x == b.x && a.y == b.y
}
