package org.trigrid.shape

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2

/** Reads the text form of [PaperText], line by line. */
internal class PaperReader(text: String, private val sourceName: String) {
    private val lines = text.split('\n').map { it.trim() }.dropLastWhile { it.isEmpty() }
    private var at = 0

    fun read(kind: PaperShape): Shape {
        val shape = try {
            shape(kind)
        } catch (e: InvalidShapeException) {
            fail(1, e.message ?: "the shape is not valid", e)
        }
        if (at < lines.size) fail(at + 1, "nothing may follow the last value")
        return shape
    }

    private fun shape(kind: PaperShape): Shape = when (kind) {
        PaperShape.LINE -> Line(point(), point(), intervals(kind))
        PaperShape.LINES -> intervals(kind).let { Lines(vertices(), it) }
        PaperShape.CURVE -> intervals(kind).let { Curve(vertices(), CurveEnds.NATURAL, null, null, it) }
        PaperShape.RECTANGLE -> {
            val begin = point()
            val end = point()
            intervals(kind).let { Rectangle(begin, end, direction(), it) }
        }
        PaperShape.POLYGON -> polygon()
        PaperShape.CIRCLE -> {
            val first = point()
            val centre = point()
            checkRadius(first, centre)
            intervals(kind).let { Circle(first, centre, direction(), it) }
        }
        PaperShape.ELLIPSE -> {
            val first = point()
            val centre = point()
            val radiusX = number("x radius")
            val radiusY = number("y radius")
            intervals(kind).let { Ellipse(first, centre, radiusX, radiusY, 0.0, direction(), it) }
        }
    }

    /** Regular if the vertices are those of the regular polygon, but for rounding. */
    private fun polygon(): Polygon {
        val first = point()
        val centre = point()
        val radius = number("radius")
        val vertices = vertices()
        val traits = intervals(PaperShape.POLYGON)
        val direction = direction()
        val given = Polygon(vertices, null, traits)
        if (given.direction != direction) fail(at, "the vertices run ${PaperText.word(given.direction)}")
        val regular = Polygon.regular(first, centre, vertices.size, direction)
        val isRegular = vertices.indices.all { vertices[it].distanceTo(regular[it]) <= SAME * radius }
        return if (isRegular) Polygon(regular, centre, traits) else given
    }

    /** The first point rules; the radius must be its distance from the centre, but for single precision. */
    private fun checkRadius(first: Point2, centre: Point2) {
        val radius = number("radius")
        val distance = first.distanceTo(centre)
        if (!(Math.abs(radius - distance) <= SAME * distance)) {
            fail(at, "radius is $radius, but the first point lies $distance from the centre")
        }
    }

    private fun intervals(kind: PaperShape): Traits {
        val spacing = number("spacing")
        return Traits(kind.name.lowercase(), spacing, number("ratio"))
    }

    private fun vertices(): List<Point2> {
        val text = line("number of vertices")
        val count = text.toIntOrNull() ?: fail(at, "number of vertices was expected, not \"$text\"")
        if (count < 0 || count > lines.size) fail(at, "there are fewer than $count vertices")
        return List(count) { point() }
    }

    private fun point(): Point2 {
        val x = number("x")
        return Point2(x, number("y"))
    }

    private fun direction(): Direction {
        val text = line("direction")
        return Direction.entries.firstOrNull { it.name.equals(text, ignoreCase = true) }
            ?: fail(at, "direction must be Clockwise or Anticlockwise, not \"$text\"")
    }

    private fun number(what: String): Double {
        val text = line(what)
        return text.replace(',', '.').toDoubleOrNull() ?: fail(at, "$what was expected, not \"$text\"")
    }

    private fun line(what: String): String {
        if (at >= lines.size) fail(at + 1, "the text ends before $what")
        return lines[at++]
    }

    private fun fail(line: Int, reason: String, cause: Throwable? = null): Nothing =
        throw FileFormatException(sourceName, line, 0, reason, cause)

    private companion object {
        /** Share of the radius that single precision, which the paper's program used, may lose. */
        const val SAME = 1e-5
    }
}
