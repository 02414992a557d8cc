package org.trigrid.editor.tool

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

/**
 * The shapes that are drawn by clicks.
 *
 * @param clicks points that end the shape, or 0 where Enter ends it.
 * @param least points it needs.
 * @param isOpen whether it goes on from the end of an open walk.
 * @param steps what to do at each point; the last one for all that follow.
 */
internal enum class ShapeKind(
    val label: String,
    val key: String,
    val clicks: Int,
    val least: Int,
    val isOpen: Boolean,
    private vararg val steps: String,
) {
    LINE("Line", "L", 2, 2, true, "Click the begin of the line", "Click its end"),
    LINES("Lines", "P", 0, 2, true, "Click the first point", "Click the next point; Enter or double click ends, Backspace takes one back"),
    CURVE("Curve", "U", 0, 2, true, "Click the begin of the curve", "Click the next point; Enter or double click ends, a click on the first point closes"),
    ARC("Arc", "A", 3, 3, true, "Click the begin of the arc", "Click its end", "Click a point the arc runs through"),
    RECTANGLE("Rectangle", "R", 2, 2, false, "Click the first corner", "Click the opposite corner"),
    POLYGON("Polygon", "G", 0, 3, false, "Click the first vertex", "Click the next vertex; Enter or a click on the first closes"),
    REGULAR_POLYGON("Regular polygon", "Y", 2, 2, false, "Click the centre", "Click a vertex; Up and Down change the number of sides"),
    CIRCLE("Circle", "O", 2, 2, false, "Click the centre", "Click a point of the circle, its first node"),
    ELLIPSE("Ellipse", "E", 2, 2, false, "Click the centre", "Click the corner of the box round it"),
    CONNECTOR("Connector", "K", 2, 2, true, "Click where the connector begins", "Click where the opening begins; draw the opening there next"),
    ;

    fun hint(points: Int): String = steps[minOf(points, steps.size - 1)]

    /**
     * The shape through [points], or null where they are too few for one. May be called with one point fewer than the
     * shape needs, to show what there is so far.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if the points make no shape.
     */
    fun make(points: List<Point2>, spacing: Double, sides: Int, isClosed: Boolean): Shape? {
        val p = points
        if (p.size < 2) return null
        return when (this) {
            LINE, CONNECTOR -> Line(p[0], p[1], spacing)
            LINES -> Lines(p, spacing)
            CURVE -> Curve(p, spacing).let { if (isClosed && p.size >= CLOSED_LEAST) it.closed() else it }
            ARC -> if (p.size == 2) Line(p[0], p[1], spacing) else Arc.through(p[0], p[2], p[1], spacing)
            RECTANGLE -> Rectangle(p[0], p[1], spacing)
            POLYGON -> if (p.size == 2) Line(p[0], p[1], spacing) else Polygon(p, spacing)
            REGULAR_POLYGON -> Polygon(p[1], p[0], sides, spacing)
            CIRCLE -> Circle(p[1], p[0], spacing)
            ELLIPSE -> Ellipse(p[0].x, p[0].y, Math.abs(p[1].x - p[0].x), Math.abs(p[1].y - p[0].y), spacing)
        }
    }

    private companion object {
        const val CLOSED_LEAST = 3
    }
}
