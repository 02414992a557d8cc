package org.trigrid.editor.inspector

import org.trigrid.domain.Path
import org.trigrid.editor.command.ReplaceShape
import org.trigrid.editor.command.ShapeCommands
import org.trigrid.editor.tool.Figures
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

/** The fields of each kind of shape. */
internal object ShapeFields {
    fun title(path: Path, number: Int): String =
        (if (path.isConnector(number)) "Connector" else path.shape(number).javaClass.simpleName) + " ${number + 1}"

    fun geometry(path: Path, number: Int, shape: Shape): List<InspectorField> = when (shape) {
        is Line -> if (path.joinsWalks(number)) joined(shape) else ends(number, shape) { a, b -> shape.withEnds(a, b) } +
            InspectorField("Length", Figures.length(shape.firstPoint.distanceTo(shape.lastPoint)), "length")
        is Arc -> ends(number, shape) { a, b -> shape.withEnds(a, b) } + listOf(
            number(number, "Angle", shape.angleDegrees, "°") { shape.withAngleDegrees(it) },
            InspectorField("Radius", Figures.length(shape.radius), "length"),
        )
        is Lines -> listOf(InspectorField("Vertices", shape.vertices.size.toString()))
        is Curve -> curve(number, shape)
        is Rectangle -> rectangle(number, shape)
        is Polygon -> polygon(number, shape)
        is Circle -> circle(number, shape)
        is Ellipse -> ellipse(number, shape)
    }

    private fun ends(number: Int, shape: Shape, make: (Point2, Point2) -> Shape): List<InspectorField> =
        point(number, "Begin", shape.firstPoint) { make(it, shape.lastPoint) } +
            point(number, "End", shape.lastPoint) { make(shape.firstPoint, it) }

    /** A connector between two walks goes where its nodes go. */
    private fun joined(shape: Line): List<InspectorField> = listOf(
        InspectorField("Begin", shape.firstPoint.let { "${Figures.length(it.x)}, ${Figures.length(it.y)}" }),
        InspectorField("End", shape.lastPoint.let { "${Figures.length(it.x)}, ${Figures.length(it.y)}" }),
        InspectorField("Length", Figures.length(shape.firstPoint.distanceTo(shape.lastPoint))),
    )

    private fun rectangle(number: Int, shape: Rectangle): List<InspectorField> {
        val a = shape.firstPoint
        val b = shape.endCorner
        return point(number, "Begin", a) { shape.withCorners(it, Point2(b.x + it.x - a.x, b.y + it.y - a.y)) } + listOf(
            number(number, "Width", Math.abs(b.x - a.x), "length") {
                shape.withCorners(a, Point2(a.x + Math.copySign(FieldNumbers.positive(Figures.exact(it)), b.x - a.x), b.y))
            },
            number(number, "Height", Math.abs(b.y - a.y), "length") {
                shape.withCorners(a, Point2(b.x, a.y + Math.copySign(FieldNumbers.positive(Figures.exact(it)), b.y - a.y)))
            },
            direction(number, shape.direction),
        )
    }

    private fun polygon(number: Int, shape: Polygon): List<InspectorField> {
        val vertices = if (shape.isRegular) {
            InspectorField("Vertices", shape.vertices.size.toString()) { text ->
                val count = FieldNumbers.whole(text, 3..1000)
                val changed = Polygon(shape.firstPoint, shape.centre, count, shape.spacing).withDirection(shape.direction)
                    .withRatio(shape.ratio).withDistribution(shape.distribution).withRounding(shape.rounding).withName(shape.name)
                ReplaceShape(number, changed, "number of vertices", "vertices $number")
            }
        } else {
            InspectorField("Vertices", shape.vertices.size.toString())
        }
        return listOf(
            vertices,
            InspectorField("Centre", "${Figures.length(shape.centre.x)}, ${Figures.length(shape.centre.y)}", "length"),
            direction(number, shape.direction),
        )
    }

    private fun circle(number: Int, shape: Circle): List<InspectorField> =
        point(number, "Centre", shape.centre) { shape.withCentre(it) } +
            number(number, "Radius", shape.radius, "length") { shape.withRadius(it) } +
            point(number, "First", shape.firstPoint) { shape.withFirstPoint(it) } +
            direction(number, shape.direction)

    private fun ellipse(number: Int, shape: Ellipse): List<InspectorField> =
        point(number, "Centre", shape.centre) { shape.withCentre(it) } + listOf(
            number(number, "Radius x", shape.radiusX, "length") { shape.withRadii(it, shape.radiusY) },
            number(number, "Radius y", shape.radiusY, "length") { shape.withRadii(shape.radiusX, it) },
            number(number, "Rotation", shape.rotationDegrees, "°") { shape.withRotationDegrees(it) },
            direction(number, shape.direction),
        )

    private fun curve(number: Int, shape: Curve): List<InspectorField> {
        val ends = InspectorField("Ends", word(shape.ends), choices = listOf(CurveEnds.NATURAL, CurveEnds.CLOSED).map(::word)) { text ->
            ReplaceShape(number, if (text == word(CurveEnds.CLOSED)) shape.closed() else shape.natural(), "ends of the curve")
        }
        return listOf(InspectorField("Vertices", shape.vertices.size.toString()), ends)
    }

    private fun direction(number: Int, value: Direction): InspectorField = InspectorField(
        "Direction", word(value), choices = Direction.entries.map(::word),
        help = "Travelled as the outer boundary a shape is included, against it left out",
    ) { ShapeCommands.reverse(setOf(number)) }

    private fun point(number: Int, label: String, value: Point2, make: (Point2) -> Shape): List<InspectorField> = listOf(
        number(number, "$label x", value.x, "length") { make(Point2(it, value.y)) },
        number(number, "$label y", value.y, "length") { make(Point2(value.x, it)) },
    )

    private fun number(number: Int, label: String, value: Double, unit: String, make: (Double) -> Shape) =
        InspectorField(label, Figures.exact(value), unit) { text ->
            ReplaceShape(number, make(FieldNumbers.any(text)), label.lowercase(), "$label $number")
        }

    private fun word(value: Enum<*>): String = value.name.lowercase().replaceFirstChar { it.uppercase() }
}
