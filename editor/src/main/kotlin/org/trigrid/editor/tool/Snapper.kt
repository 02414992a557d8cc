package org.trigrid.editor.tool

import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.Picking
import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Shape

/** Draws the mouse to places that people mean: nodes first, then ends, centres, middles, intersections, the grid last. */
internal class Snapper(private val document: EditorDocument, private val settings: SnapSettings) {
    private val places: List<SnapPoint> by lazy {
        (0 until document.path.shapeCount).flatMap { placesOf(document.path.shape(it)) }
    }

    /**
     * @param anchor the place that Shift holds angles about, or null.
     * @param own vertices of the shape being drawn, which count as ends.
     * @param except nodes that are being dragged and so are no places to go to.
     */
    fun snap(
        input: PointerInput,
        anchor: Point2? = null,
        own: List<Point2> = emptyList(),
        except: Set<Int> = emptySet(),
    ): SnapPoint {
        val free = Point2(input.x, input.y)
        if (input.isAltDown) return SnapPoint(free, SnapKind.NONE)
        if (input.isShiftDown && anchor != null) return SnapPoint(held(anchor, free, input.pixel), SnapKind.ANGLE)
        val reach = REACH * input.pixel
        if (settings.toNodes) {
            val node = Picking.node(document, input.x, input.y, reach, except)
            if (node >= 0) return SnapPoint(document.nodes.point(node), SnapKind.NODE, node)
            own.firstOrNull { it.distanceTo(free) <= reach }?.let { return SnapPoint(it, SnapKind.END) }
        }
        if (settings.toShapes) {
            nearest(places, free, reach)?.let { return it }
            if (except.isEmpty()) alongSegments(input, reach)?.let { return it }
        }
        return if (settings.toGrid) grid(input) else SnapPoint(free, SnapKind.NONE)
    }

    /** The nearest crossing of two segments, or the middle of one of a loop, whose segments are its shapes. */
    private fun alongSegments(input: PointerInput, reach: Double): SnapPoint? {
        val nodes = document.nodes
        val near = ArrayList<Pair<Point2, Point2>>()
        val found = ArrayList<SnapPoint>()
        for (outline in document.outlines) {
            for (step in 0 until outline.stepCount) {
                val a = nodes.point(outline.nodes[step])
                val b = nodes.point(outline.stepEnd(step))
                val foot = Picking.nearest(a, b, input.x, input.y)
                if (Math.hypot(foot.x - input.x, foot.y - input.y) > reach) continue
                near.add(a to b)
                if (outline.loop >= 0) found.add(SnapPoint(middle(a, b), SnapKind.MIDDLE))
                if (near.size > MOST_SEGMENTS) return null
            }
        }
        for (i in near.indices) {
            for (j in 0 until i) crossing(near[i], near[j])?.let { found.add(SnapPoint(it, SnapKind.INTERSECTION)) }
        }
        return nearest(found, Point2(input.x, input.y), reach)
    }

    private fun crossing(p: Pair<Point2, Point2>, q: Pair<Point2, Point2>): Point2? {
        val ux = p.second.x - p.first.x
        val uy = p.second.y - p.first.y
        val vx = q.second.x - q.first.x
        val vy = q.second.y - q.first.y
        val area = ux * vy - uy * vx
        if (area == 0.0) return null
        val wx = q.first.x - p.first.x
        val wy = q.first.y - p.first.y
        val s = (wx * vy - wy * vx) / area
        val t = (wx * uy - wy * ux) / area
        val touches = s < INSIDE || s > 1 - INSIDE || t < INSIDE || t > 1 - INSIDE
        return if (touches) null else Point2(p.first.x + s * ux, p.first.y + s * uy)
    }

    private fun nearest(candidates: List<SnapPoint>, free: Point2, reach: Double): SnapPoint? =
        candidates.filter { it.point.distanceTo(free) <= reach }.minByOrNull { it.point.distanceTo(free) }

    private fun grid(input: PointerInput): SnapPoint {
        val step = Grid.stepFor(input.pixel)
        return SnapPoint(Point2(Grid.nearest(input.x, step), Grid.nearest(input.y, step)), SnapKind.GRID)
    }

    /** On the ray from [anchor] at a multiple of the angle step, at a distance that is a multiple of a tenth of the grid. */
    private fun held(anchor: Point2, free: Point2, pixel: Double): Point2 {
        val step = Math.toRadians(settings.angleStep)
        val angle = Math.rint(StrictMath.atan2(free.y - anchor.y, free.x - anchor.x) / step) * step
        val along = (free.x - anchor.x) * StrictMath.cos(angle) + (free.y - anchor.y) * StrictMath.sin(angle)
        val length = if (settings.toGrid) Grid.nearest(along, Grid.stepFor(pixel)) else along
        val quarter = Math.rint(angle / (Math.PI / 2))
        if (Math.abs(angle - quarter * Math.PI / 2) < EXACT) {
            val turns = Math.floorMod(quarter.toInt(), 4)
            val dx = if (turns == 0) length else if (turns == 2) -length else 0.0
            val dy = if (turns == 1) length else if (turns == 3) -length else 0.0
            return Point2(anchor.x + dx, anchor.y + dy)
        }
        return Point2(anchor.x + length * StrictMath.cos(angle), anchor.y + length * StrictMath.sin(angle))
    }

    private fun placesOf(shape: Shape): List<SnapPoint> = when (shape) {
        is Circle -> listOf(SnapPoint(shape.centre, SnapKind.CENTRE))
        is Ellipse -> listOf(SnapPoint(shape.centre, SnapKind.CENTRE))
        is Rectangle -> ofRectangle(shape.firstPoint, shape.endCorner)
        is Arc -> listOf(SnapPoint(centre(shape), SnapKind.CENTRE))
        is Line -> listOf(SnapPoint(middle(shape.firstPoint, shape.lastPoint), SnapKind.MIDDLE))
        is Lines -> shape.vertices.zipWithNext { a, b -> SnapPoint(middle(a, b), SnapKind.MIDDLE) }
        is Polygon -> shape.vertices.indices.map {
            SnapPoint(middle(shape.vertices[it], shape.vertices[(it + 1) % shape.vertices.size]), SnapKind.MIDDLE)
        } + SnapPoint(shape.centre, SnapKind.CENTRE)
        else -> emptyList()
    }

    private fun ofRectangle(a: Point2, c: Point2): List<SnapPoint> {
        val m = middle(a, c)
        val sides = listOf(Point2(m.x, a.y), Point2(c.x, m.y), Point2(m.x, c.y), Point2(a.x, m.y))
        return sides.map { SnapPoint(it, SnapKind.MIDDLE) } + SnapPoint(m, SnapKind.CENTRE)
    }

    /** To the left of the way from begin to end where the arc turns to the left by less than half a turn. */
    private fun centre(arc: Arc): Point2 {
        val m = middle(arc.firstPoint, arc.lastPoint)
        val height = 0.5 / StrictMath.tan(Math.toRadians(arc.angleDegrees) / 2)
        return Point2(m.x - height * (arc.lastPoint.y - arc.firstPoint.y), m.y + height * (arc.lastPoint.x - arc.firstPoint.x))
    }

    private fun middle(a: Point2, b: Point2): Point2 = Point2((a.x + b.x) / 2, (a.y + b.y) / 2)

    companion object {
        /** In pixels. */
        const val REACH = 9.0
        private const val MOST_SEGMENTS = 40
        private const val INSIDE = 1e-9
        private const val EXACT = 1e-9
    }
}
