package org.trigrid.project

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import org.trigrid.MeshOptions
import org.trigrid.domain.AppendStep
import org.trigrid.domain.BackStep
import org.trigrid.domain.ConnectStep
import org.trigrid.domain.DeleteStep
import org.trigrid.domain.InsertStep
import org.trigrid.domain.MoveStep
import org.trigrid.domain.NewLoopStep
import org.trigrid.domain.Path
import org.trigrid.domain.PathStep
import org.trigrid.domain.TurnStep
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
import org.trigrid.spacing.SizeSources

/** Makes the JSON of a project file. */
internal class ProjectWriter(private val project: Project) {
    fun write(): JsonObject = buildJsonObject {
        put("format", ProjectReader.FORMAT)
        val regions = InnerWriter.regions(project)
        put("version", if (project.inner.isEmpty() && regions.isEmpty() && project.order == 1) FIRST_VERSION else ProjectFile.VERSION)
        put("region", project.regionName)
        put("connectors", JsonFields.word(if (project.keepsConnectors) Connectors.KEEP else Connectors.DROP))
        put("defaults", defaults(project.defaults))
        put("mesh", options(project.options))
        if (project.order != 1) put("order", project.order)
        put("path", JsonArray(project.path.steps.map { step(it) }))
        if (project.loops.isNotEmpty()) put("loops", JsonArray(project.loops.map { loop(it) }))
        if (regions.isNotEmpty()) put("regions", regions)
        if (project.inner.lineCount > 0) put("lines", InnerWriter.lines(project.inner))
        if (project.inner.pointCount > 0) put("points", InnerWriter.points(project.inner))
        if (project.colours.isNotEmpty()) put("colours", buildJsonObject { project.colours.forEach { (name, colour) -> put(name, colour) } })
        project.background?.let { put("background", background(it)) }
    }

    private fun background(background: Background) = buildJsonObject {
        put("file", background.file)
        put("lowerLeft", point(background.lowerLeft))
        put("pixelSize", number(background.pixelSize))
        put("rotationDegrees", number(background.rotationDegrees))
        put("opacity", number(background.opacity))
        put("locked", background.isLocked)
    }

    private fun defaults(defaults: ShapeDefaults) = buildJsonObject {
        put("spacing", number(defaults.spacing))
        put("ratio", number(defaults.ratio))
        put("distribution", JsonFields.word(defaults.distribution))
        put("rounding", JsonFields.word(defaults.rounding))
    }

    /** What differs from the standard options; a file that leaves an option out has the standard one. */
    private fun options(options: MeshOptions) = buildJsonObject {
        val standard = MeshOptions.DEFAULT
        if (options.sizes != standard.sizes) put("sizes", JsonFields.word(options.sizes))
        if (options.gradation != standard.gradation) put("gradation", number(options.gradation))
        if (options.minSize != standard.minSize) put("minSize", number(options.minSize))
        if (options.maxSize != standard.maxSize) put("maxSize", number(options.maxSize))
        if (options.strategy != standard.strategy) put("strategy", JsonFields.word(options.strategy))
        if (options.improve != standard.improve) put("improve", options.improve)
        if (options.smoothingTolerance != standard.smoothingTolerance) put("smoothingTolerance", number(options.smoothingTolerance))
        if (options.numbering != standard.numbering) put("numbering", JsonFields.word(options.numbering))
        if (options.maxElements != standard.maxElements) put("maxElements", options.maxElements)
        if (options.sizeSources.count > 0) put("sizeSources", sources(options.sizeSources))
    }

    private fun sources(sources: SizeSources) = JsonArray(
        List(sources.count) { i ->
            val xy = sources.placeOf(i)
            val places = List(xy.size / 2) { Point2(xy[2 * it], xy[2 * it + 1]) }
            buildJsonObject {
                put("size", number(sources.sizeOf(i)))
                if (places.size == 1) put("at", point(places[0])) else put("along", points(places))
            }
        },
    )

    private fun step(step: PathStep): JsonObject = buildJsonObject {
        when (step) {
            is AppendStep -> append(step)
            is ConnectStep -> {
                put("type", "connect")
                put("from", step.from.toString())
                put("to", step.to.toString())
                if (step.isTurned) put("turned", true)
                if (step.line.name.isNotEmpty()) put("name", step.line.name)
                settings(step.line)
            }
            is BackStep -> put("type", "back")
            is NewLoopStep -> put("type", "new-loop")
            is MoveStep -> {
                put("type", "move")
                put("node", step.node.toString())
                put("to", point(Point2(step.x, step.y)))
                if (step.isWithNext) put("withNext", true)
            }
            is TurnStep -> {
                put("type", "turn")
                put("node", step.node.toString())
            }
            is DeleteStep -> {
                put("type", "delete")
                put("node", step.node.toString())
            }
            is InsertStep -> {
                put("type", "insert")
                put("node", step.node.toString())
                put("from", step.from.toString())
                put("to", step.to.toString())
                put("at", point(Point2(step.x, step.y)))
            }
        }
    }

    private fun JsonObjectBuilder.append(step: AppendStep) {
        val shape = step.shape
        put("type", if (step.isConnector) ProjectReader.CONNECTOR else shape.traits.kind)
        if (shape.name.isNotEmpty()) put("name", shape.name)
        geometry(shape)
        settings(shape)
    }

    private fun JsonObjectBuilder.settings(shape: Shape) {
        val defaults = project.defaults
        if (shape.spacing != defaults.spacing) put("spacing", number(shape.spacing))
        if (shape.ratio != defaults.ratio) put("ratio", number(shape.ratio))
        if (shape.distribution != defaults.distribution) put("distribution", JsonFields.word(shape.distribution))
        if (shape.rounding != defaults.rounding) put("rounding", JsonFields.word(shape.rounding))
    }

    private fun JsonObjectBuilder.geometry(shape: Shape) {
        when (shape) {
            is Line -> ends(shape.firstPoint, shape.lastPoint)
            is Lines -> put("vertices", points(shape.vertices))
            is Curve -> curve(shape)
            is Rectangle -> {
                ends(shape.firstPoint, shape.endCorner)
                direction(shape.direction)
            }
            is Polygon -> polygon(shape)
            is Circle -> {
                round(shape.firstPoint, shape.centre)
                direction(shape.direction)
            }
            is Ellipse -> {
                round(shape.firstPoint, shape.centre)
                put("radiusX", number(shape.radiusX))
                put("radiusY", number(shape.radiusY))
                put("rotationDegrees", number(shape.rotationDegrees))
                direction(shape.direction)
            }
            is Arc -> {
                ends(shape.firstPoint, shape.lastPoint)
                put("angleDegrees", number(shape.angleDegrees))
            }
        }
    }

    private fun JsonObjectBuilder.ends(begin: Point2, end: Point2) {
        put("begin", point(begin))
        put("end", point(end))
    }

    private fun JsonObjectBuilder.round(firstPoint: Point2, centre: Point2) {
        put("firstPoint", point(firstPoint))
        put("centre", point(centre))
    }

    private fun JsonObjectBuilder.direction(direction: Direction) {
        put("direction", JsonFields.word(direction))
    }

    private fun JsonObjectBuilder.curve(shape: Curve) {
        put("vertices", points(shape.vertices))
        if (shape.ends != CurveEnds.NATURAL) put("ends", JsonFields.word(shape.ends))
        shape.beginTangent?.let { put("beginTangent", point(it)) }
        shape.endTangent?.let { put("endTangent", point(it)) }
    }

    private fun JsonObjectBuilder.polygon(shape: Polygon) {
        if (!shape.isRegular) {
            put("vertices", points(shape.vertices))
            return
        }
        round(shape.firstPoint, shape.centre)
        put("vertexCount", shape.vertices.size)
        direction(shape.direction)
    }

    private fun loop(loop: NodeLoop): JsonObject = buildJsonObject {
        val names = loop.segmentTags
        val name = names.firstOrNull() ?: Path.UNNAMED_TAG
        if (names.all { it == name }) {
            put("name", name)
        } else {
            put("segmentNames", JsonArray(names.map { JsonPrimitive(it) }))
        }
        put("nodes", points(List(loop.nodeCount) { Point2(loop.x(it), loop.y(it)) }))
    }

    companion object {
        /** Without regions, lines, points and an order a file says nothing that programs of this version do not know. */
        private const val FIRST_VERSION = 1

        fun points(points: List<Point2>) = JsonArray(points.map { point(it) })

        fun point(point: Point2) = JsonArray(listOf(number(point.x), number(point.y)))

        @OptIn(ExperimentalSerializationApi::class)
        fun number(value: Double) = JsonUnquotedLiteral(NumberText.of(value))
    }
}
