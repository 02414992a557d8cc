package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.domain.AppendStep
import org.trigrid.domain.BackStep
import org.trigrid.domain.DeleteStep
import org.trigrid.domain.InsertStep
import org.trigrid.domain.MoveStep
import org.trigrid.domain.NewLoopStep
import org.trigrid.domain.Path
import org.trigrid.domain.PathStep
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

/** Makes the JSON of a project file. */
internal class ProjectWriter(private val project: Project) {
    fun write(): JsonObject = JsonObject().also { file ->
        file["format"] = ProjectReader.FORMAT
        file["version"] = JsonNumber(ProjectFile.VERSION.toString())
        file["region"] = project.regionName
        file["connectors"] = JsonFields.word(if (project.keepsConnectors) Connectors.KEEP else Connectors.DROP)
        file["defaults"] = defaults(project.defaults)
        file["mesh"] = options(project.options)
        file["path"] = JsonArray(project.path.steps.map { step(it) })
        if (project.loops.isNotEmpty()) file["loops"] = JsonArray(project.loops.map { loop(it) })
    }

    private fun defaults(defaults: ShapeDefaults) = JsonObject().also {
        it["spacing"] = defaults.spacing
        it["ratio"] = defaults.ratio
        it["distribution"] = JsonFields.word(defaults.distribution)
        it["rounding"] = JsonFields.word(defaults.rounding)
    }

    /** What differs from the standard options; a file that leaves an option out has the standard one. */
    private fun options(options: MeshOptions) = JsonObject().also {
        val standard = MeshOptions.DEFAULT
        if (options.sizes != standard.sizes) it["sizes"] = JsonFields.word(options.sizes)
        if (options.gradation != standard.gradation) it["gradation"] = options.gradation
        if (options.minSize != standard.minSize) it["minSize"] = options.minSize
        if (options.maxSize != standard.maxSize) it["maxSize"] = options.maxSize
        if (options.strategy != standard.strategy) it["strategy"] = JsonFields.word(options.strategy)
        if (options.improve != standard.improve) it["improve"] = JsonBoolean(options.improve)
        if (options.smoothingTolerance != standard.smoothingTolerance) it["smoothingTolerance"] = options.smoothingTolerance
        if (options.numbering != standard.numbering) it["numbering"] = JsonFields.word(options.numbering)
        if (options.maxElements != standard.maxElements) it["maxElements"] = JsonNumber(options.maxElements.toString())
    }

    private fun step(step: PathStep): JsonObject = JsonObject().also {
        when (step) {
            is AppendStep -> append(step, it)
            is BackStep -> it["type"] = "back"
            is NewLoopStep -> it["type"] = "new-loop"
            is MoveStep -> {
                it["type"] = "move"
                it["node"] = step.node.toString()
                it["to"] = point(Point2(step.x, step.y))
            }
            is DeleteStep -> {
                it["type"] = "delete"
                it["node"] = step.node.toString()
            }
            is InsertStep -> {
                it["type"] = "insert"
                it["node"] = step.node.toString()
                it["from"] = step.from.toString()
                it["to"] = step.to.toString()
                it["at"] = point(Point2(step.x, step.y))
            }
        }
    }

    private fun append(step: AppendStep, file: JsonObject) {
        val shape = step.shape
        file["type"] = if (step.isConnector) ProjectReader.CONNECTOR else shape.traits.kind
        if (shape.name.isNotEmpty()) file["name"] = shape.name
        geometry(shape, file)
        val defaults = project.defaults
        if (shape.spacing != defaults.spacing) file["spacing"] = shape.spacing
        if (shape.ratio != defaults.ratio) file["ratio"] = shape.ratio
        if (shape.distribution != defaults.distribution) file["distribution"] = JsonFields.word(shape.distribution)
        if (shape.rounding != defaults.rounding) file["rounding"] = JsonFields.word(shape.rounding)
    }

    private fun geometry(shape: Shape, file: JsonObject) {
        when (shape) {
            is Line -> ends(shape.firstPoint, shape.lastPoint, file)
            is Lines -> file["vertices"] = points(shape.vertices)
            is Curve -> curve(shape, file)
            is Rectangle -> {
                ends(shape.firstPoint, shape.endCorner, file)
                direction(shape.direction, file)
            }
            is Polygon -> polygon(shape, file)
            is Circle -> {
                round(shape.firstPoint, shape.centre, file)
                direction(shape.direction, file)
            }
            is Ellipse -> {
                round(shape.firstPoint, shape.centre, file)
                file["radiusX"] = shape.radiusX
                file["radiusY"] = shape.radiusY
                file["rotationDegrees"] = shape.rotationDegrees
                direction(shape.direction, file)
            }
            is Arc -> {
                ends(shape.firstPoint, shape.lastPoint, file)
                file["angleDegrees"] = shape.angleDegrees
            }
        }
    }

    private fun ends(begin: Point2, end: Point2, file: JsonObject) {
        file["begin"] = point(begin)
        file["end"] = point(end)
    }

    private fun round(firstPoint: Point2, centre: Point2, file: JsonObject) {
        file["firstPoint"] = point(firstPoint)
        file["centre"] = point(centre)
    }

    private fun direction(direction: Direction, file: JsonObject) {
        file["direction"] = JsonFields.word(direction)
    }

    private fun curve(shape: Curve, file: JsonObject) {
        file["vertices"] = points(shape.vertices)
        if (shape.ends != CurveEnds.NATURAL) file["ends"] = JsonFields.word(shape.ends)
        shape.beginTangent?.let { file["beginTangent"] = point(it) }
        shape.endTangent?.let { file["endTangent"] = point(it) }
    }

    private fun polygon(shape: Polygon, file: JsonObject) {
        if (!shape.isRegular) {
            file["vertices"] = points(shape.vertices)
            return
        }
        round(shape.firstPoint, shape.centre, file)
        file["vertexCount"] = JsonNumber(shape.vertices.size.toString())
        direction(shape.direction, file)
    }

    private fun loop(loop: NodeLoop): JsonObject = JsonObject().also { file ->
        val names = loop.segmentTags
        val name = names.firstOrNull() ?: Path.UNNAMED_TAG
        if (names.all { it == name }) {
            file["name"] = name
        } else {
            file["segmentNames"] = JsonArray(names.map { JsonString(it) })
        }
        file["nodes"] = points(List(loop.nodeCount) { Point2(loop.x(it), loop.y(it)) })
    }

    private fun points(points: List<Point2>) = JsonArray(points.map { point(it) })

    private fun point(point: Point2) = JsonArray(listOf(number(point.x), number(point.y)))

    private fun number(value: Double) = JsonNumber(NumberText.of(value))
}
