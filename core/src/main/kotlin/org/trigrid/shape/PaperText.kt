package org.trigrid.shape

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.geometry.Point2

/**
 * The paper's own text form of a shape: one value a line, as `Write` and `Read` of its listing have it (appendix A).
 *
 * The listing gives the line's order: begin x, begin y, end x, end y, spacing, ratio. The other shapes "follow exactly
 * the same concept": their values are in the order in which the paper lists their properties, points as x then y, a
 * set of vertices after its number, and the direction as `Clockwise` or `Anticlockwise`:
 *
 * - rectangle: begin corner, end corner, spacing, ratio, direction
 * - polygon: first point, centre, radius, number of vertices, vertices, spacing, ratio, direction
 * - circle: first point, centre, radius, spacing, ratio, direction
 * - ellipse: first point, centre, x radius, y radius, spacing, ratio, direction
 * - lines, curve: spacing, ratio, number of vertices, vertices
 *
 * The form holds no name, and only the paper's way to explode.
 */
public object PaperText {
    /**
     * The shape's text, each line ended by a line feed; numbers keep all their digits.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if the paper has no such shape: an arc, a rotated ellipse,
     *   a clamped or closed curve, another distribution than the linear one or another rounding than the nearest.
     */
    @JvmStatic
    public fun write(shape: Shape): String {
        val kind = shape.traits.kind
        if (shape.distribution != Distribution.LINEAR) Traits.refuse(kind, "the paper's text holds no distribution")
        if (shape.rounding != Rounding.NEAREST) Traits.refuse(kind, "the paper's text holds no rounding")
        val values: List<Any> = when (shape) {
            is Line -> point(shape.firstPoint) + point(shape.lastPoint) + intervals(shape)
            is Lines -> intervals(shape) + vertices(shape.vertices)
            is Curve -> {
                if (shape.ends != CurveEnds.NATURAL) Traits.refuse(kind, "the paper's text holds natural ends only")
                intervals(shape) + vertices(shape.vertices)
            }
            is Rectangle -> point(shape.firstPoint) + point(shape.endCorner) + intervals(shape) + word(shape.direction)
            is Polygon -> point(shape.firstPoint) + point(shape.centre) + shape.radius + vertices(shape.vertices) +
                intervals(shape) + word(shape.direction)
            is Circle -> point(shape.firstPoint) + point(shape.centre) + shape.radius + intervals(shape) +
                word(shape.direction)
            is Ellipse -> {
                if (shape.rotationDegrees != 0.0) Traits.refuse(kind, "the paper's text holds no rotation")
                point(shape.firstPoint) + point(shape.centre) + shape.radiusX + shape.radiusY + intervals(shape) +
                    word(shape.direction)
            }
            is Arc -> Traits.refuse(kind, "the paper has no arcs")
        }
        return values.joinToString("\n", postfix = "\n")
    }

    /**
     * Reads the text of one shape. A comma in the place of a number's point is allowed, as some locales write it.
     *
     * @param sourceName what messages call the text: a file's name.
     * @throws FileFormatException with the line of what is wrong.
     */
    @JvmStatic
    public fun read(kind: PaperShape, text: String, sourceName: String): Shape = PaperReader(text, sourceName).read(kind)

    private fun point(point: Point2): List<Any> = listOf(point.x, point.y)

    private fun intervals(shape: Shape): List<Any> = listOf(shape.spacing, shape.ratio)

    private fun vertices(vertices: List<Point2>): List<Any> = listOf(vertices.size) + vertices.flatMap { point(it) }

    internal fun word(direction: Direction): String = direction.name[0] + direction.name.substring(1).lowercase()
}
