package org.trigrid.project

import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Curve
import org.trigrid.shape.CurveEnds
import org.trigrid.shape.Direction
import org.trigrid.shape.Distribution
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Lines
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Rounding
import org.trigrid.shape.Shape
import org.trigrid.shape.Traits

/** Reads one shape of a project file. */
internal class ShapeReader(private val fields: JsonFields, private val defaults: ShapeDefaults) {
    /** The shape, or null if there is no such [type]. */
    fun read(type: String): Shape? = when (type) {
        "line" -> Line(fields.point("begin"), fields.point("end"), traits(type))
        "lines" -> Lines(fields.points("vertices"), traits(type))
        "curve" -> curve(traits(type))
        "rectangle" -> Rectangle(fields.point("begin"), fields.point("end"), direction(), traits(type))
        "polygon" -> polygon(traits(type))
        "circle" -> Circle(firstPoint("radius"), fields.point("centre"), direction(), traits(type))
        "ellipse" -> ellipse(traits(type))
        "arc" -> Arc(fields.point("begin"), fields.point("end"), fields.number("angleDegrees"), traits(type))
        else -> null
    }

    /** The connector between two walks, whose ends are where its nodes are. */
    fun connection(): Line = Line(Point2(0.0, 0.0), Point2(1.0, 0.0), traits("line"))

    private fun traits(kind: String) = Traits(
        kind,
        fields.number("spacing", defaults.spacing),
        fields.number("ratio", defaults.ratio),
        fields.choice("distribution", Distribution.entries, defaults.distribution),
        fields.choice("rounding", Rounding.entries, defaults.rounding),
        fields.string("name", ""),
    )

    private fun direction(): Direction = fields.choice("direction", Direction.entries, Direction.ANTICLOCKWISE)

    /** The first point, or for a file written by hand the one to the right of the centre, given the radius. */
    private fun firstPoint(radiusKey: String): Point2 {
        if (fields.has("firstPoint") || !fields.has(radiusKey)) return fields.point("firstPoint")
        val radius = fields.number(radiusKey)
        Traits.positive("shape", radiusKey, radius)
        return fields.point("centre").let { Point2(it.x + radius, it.y) }
    }

    private fun curve(traits: Traits): Curve {
        val ends = fields.choice("ends", CurveEnds.entries, CurveEnds.NATURAL)
        val clamped = ends == CurveEnds.CLAMPED
        val begin = if (clamped) fields.point("beginTangent") else null
        val end = if (clamped) fields.point("endTangent") else null
        return Curve(fields.points("vertices"), ends, begin, end, traits)
    }

    private fun polygon(traits: Traits): Polygon {
        if (fields.has("vertices")) return Polygon(fields.points("vertices"), null, traits)
        val centre = fields.point("centre")
        val vertices = Polygon.regular(firstPoint("radius"), centre, fields.whole("vertexCount"), direction())
        return Polygon(vertices, centre, traits)
    }

    private fun ellipse(traits: Traits): Ellipse {
        val centre = fields.point("centre")
        val radiusX = fields.number("radiusX")
        val radiusY = fields.number("radiusY")
        val rotation = fields.number("rotationDegrees", 0.0)
        if (fields.has("firstPoint")) {
            return Ellipse(fields.point("firstPoint"), centre, radiusX, radiusY, rotation, direction(), traits)
        }
        val rightmost = Point2(centre.x + radiusX, centre.y)
        return Ellipse(rightmost, centre, radiusX, radiusY, 0.0, direction(), traits).withRotationDegrees(rotation)
    }
}
