package org.trigrid.project

import org.trigrid.MeshOptions
import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.domain.AppendStep
import org.trigrid.domain.BackStep
import org.trigrid.domain.ConnectStep
import org.trigrid.domain.DeleteStep
import org.trigrid.domain.InsertStep
import org.trigrid.domain.KeyedStep
import org.trigrid.domain.MoveStep
import org.trigrid.domain.NewLoopStep
import org.trigrid.domain.NodeKey
import org.trigrid.domain.Path
import org.trigrid.domain.PathStep
import org.trigrid.domain.TurnStep
import org.trigrid.front.Strategy
import org.trigrid.io.JsonDocument
import org.trigrid.numbering.NumberingMethod
import org.trigrid.shape.Distribution
import org.trigrid.shape.Rounding
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes

/** Makes a [Project] of the text of a project file. */
internal object ProjectReader {
    const val FORMAT = "trigrid"
    const val CONNECTOR = "connector"

    /** @throws org.trigrid.diagnostics.FileFormatException if [document] is no project file. */
    fun read(document: JsonDocument): Project {
        val fields = JsonFields(JsonValue(document), "a project")
        checkVersion(fields)
        val builder = Project.builder()
        builder.regionName(fields.string("region", "domain"))
        builder.keepConnectors(fields.choice("connectors", Connectors.entries, Connectors.DROP) == Connectors.KEEP)
        if (fields.has("defaults")) builder.defaults(defaults(fields.any("defaults")))
        if (fields.has("mesh")) builder.options(options(fields.any("mesh")))
        if (fields.has("order")) checked(fields) { builder.order(fields.whole("order")) }
        if (fields.has("path")) builder.path(path(fields.items("path"), builder.defaults))
        if (fields.has("loops")) builder.loops(fields.items("loops").map { loop(it) })
        InnerReader.read(fields, builder)
        if (fields.has("colours")) builder.colours(colours(fields.any("colours")))
        if (fields.has("background")) builder.background(background(fields.any("background")))
        fields.end()
        return builder.build()
    }

    /** Before anything else, so that a newer file is not blamed for keys that are new. */
    private fun checkVersion(fields: JsonFields) {
        val format = fields.string("format")
        if (format != FORMAT) fields.any("format").fail("\"format\" must be $FORMAT, not \"$format\"")
        val version = fields.whole("version")
        if (version !in 1..ProjectFile.VERSION) {
            val known = ProjectFile.VERSION
            fields.any("version").fail("version $version is not known; this program reads 1 to $known")
        }
    }

    private fun defaults(value: JsonValue): ShapeDefaults {
        val fields = JsonFields(value, "defaults")
        val standard = ShapeDefaults.STANDARD
        val spacing = fields.number("spacing", standard.spacing)
        val ratio = fields.number("ratio", standard.ratio)
        val distribution = fields.choice("distribution", Distribution.entries, standard.distribution)
        val rounding = fields.choice("rounding", Rounding.entries, standard.rounding)
        fields.end()
        return checked(fields) { ShapeDefaults(spacing, ratio, distribution, rounding) }
    }

    private fun options(value: JsonValue): MeshOptions {
        val fields = JsonFields(value, "mesh")
        val standard = MeshOptions.DEFAULT
        return checked(fields) {
            val builder = MeshOptions.builder()
                .sizes(fields.choice("sizes", Sizes.entries, standard.sizes))
                .gradation(fields.number("gradation", standard.gradation))
                .minSize(fields.number("minSize", standard.minSize))
                .strategy(fields.choice("strategy", Strategy.entries, standard.strategy))
                .improve(fields.boolean("improve", standard.improve))
                .smoothingTolerance(fields.number("smoothingTolerance", standard.smoothingTolerance))
                .numbering(fields.choice("numbering", NumberingMethod.entries, standard.numbering))
            if (fields.has("maxSize")) builder.maxSize(fields.number("maxSize"))
            if (fields.has("sizeSources")) builder.sizeSources(sources(fields.items("sizeSources")))
            if (fields.has("maxElements")) builder.maxElements(fields.whole("maxElements"))
            fields.end()
            builder.build()
        }
    }

    private fun sources(items: List<JsonValue>): SizeSources = items.fold(SizeSources.NONE) { sources, item ->
        val fields = JsonFields(item, "a size source")
        val size = fields.number("size")
        val line = if (fields.has("along")) fields.points("along").flatMap { listOf(it.x, it.y) }.toDoubleArray() else null
        val point = if (line == null) fields.point("at") else null
        fields.end()
        checked(fields) { if (point != null) sources.withPoint(size, point.x, point.y) else sources.withLine(size, *line!!) }
    }

    private fun <T> checked(fields: JsonFields, make: () -> T): T = try {
        make()
    } catch (e: IllegalArgumentException) {
        fields.refuse(e.message ?: "a value is not allowed", e)
    }

    private fun path(items: List<JsonValue>, defaults: ShapeDefaults): Path {
        val path = Path.ofSteps(items.map { step(it, defaults) })
        val undone = path.undoneSteps().firstOrNull() ?: return path
        val reason = when (val step = path.steps[undone]) {
            is KeyedStep -> "there is no such node at this step: ${step.keys().joinToString(" or ")}"
            else -> "there is no connector to travel back at this step"
        }
        items[undone].fail(reason)
    }

    private fun step(value: JsonValue, defaults: ShapeDefaults): PathStep {
        val fields = JsonFields(value, "a step of the path")
        val step = when (val type = fields.string("type")) {
            "back" -> BackStep
            "new-loop" -> NewLoopStep
            "move" -> fields.point("to").let { MoveStep(node(fields, "node"), it.x, it.y, fields.boolean("withNext", false)) }
            "connect" -> connect(fields, defaults)
            "turn" -> TurnStep(node(fields, "node"))
            "delete" -> DeleteStep(node(fields, "node"))
            "insert" -> fields.point("at").let {
                InsertStep(node(fields, "node"), node(fields, "from"), node(fields, "to"), it.x, it.y)
            }
            else -> return append(type, fields, defaults)
        }
        fields.end()
        return step
    }

    private fun connect(fields: JsonFields, defaults: ShapeDefaults): ConnectStep {
        val line = ShapeReader(fields, defaults).connection()
        return ConnectStep(line, node(fields, "from"), node(fields, "to"), fields.boolean("turned", false))
    }

    private fun colours(value: JsonValue): Map<String, String> {
        val fields = JsonFields(value, "colours")
        val colours = LinkedHashMap<String, String>()
        for (name in fields.keys()) colours[name] = fields.string(name)
        return checked(fields) { Project.builder().colours(colours).let { colours } }
    }

    private fun background(value: JsonValue): Background {
        val fields = JsonFields(value, "background")
        val file = fields.string("file")
        val corner = fields.point("lowerLeft")
        val pixel = fields.number("pixelSize")
        val turn = fields.number("rotationDegrees", 0.0)
        val opacity = fields.number("opacity", Background.USUAL_OPACITY)
        val isLocked = fields.boolean("locked", true)
        fields.end()
        return checked(fields) { Background(file, corner, pixel, turn, opacity, isLocked) }
    }

    private fun append(type: String, fields: JsonFields, defaults: ShapeDefaults): AppendStep = try {
        val shape = ShapeReader(fields, defaults).read(if (type == CONNECTOR) "line" else type)
            ?: fields.any("type").fail("\"$type\" is no type of a step")
        fields.end()
        AppendStep(shape, type == CONNECTOR)
    } catch (e: InvalidShapeException) {
        fields.refuse(e.message ?: "the shape is not valid", e)
    }

    private fun node(fields: JsonFields, key: String): NodeKey {
        val text = fields.string(key)
        return NodeKey.parse(text)
            ?: fields.any(key).fail("\"$key\" must name a node, \"shape:node\" or \"+number\", not \"$text\"")
    }

    private fun loop(value: JsonValue): NodeLoop {
        val fields = JsonFields(value, "a loop")
        val nodes = fields.points("nodes")
        val xy = DoubleArray(2 * nodes.size) { if (it % 2 == 0) nodes[it / 2].x else nodes[it / 2].y }
        val name = fields.string("name", Path.UNNAMED_TAG)
        val tags = if (fields.has("segmentNames")) fields.strings("segmentNames") else List(nodes.size) { name }
        if (tags.size != nodes.size) {
            fields.any("segmentNames").fail("${nodes.size} segments have ${tags.size} names")
        }
        fields.end()
        return NodeLoop(xy, tags)
    }
}

/** What becomes of connectors. */
internal enum class Connectors { DROP, KEEP }
