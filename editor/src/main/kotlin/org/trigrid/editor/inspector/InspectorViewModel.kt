package org.trigrid.editor.inspector

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.command.ChangeShapes
import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.command.MoveNodes
import org.trigrid.editor.command.ProjectCommands
import org.trigrid.editor.command.SpreadNodes
import org.trigrid.editor.document.ShapeRole
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.Figures
import org.trigrid.geometry.Point2
import org.trigrid.project.ShapeDefaults
import org.trigrid.shape.Distribution
import org.trigrid.shape.Line
import org.trigrid.shape.Rounding
import org.trigrid.shape.Shape

/** What the inspector shows of what is picked, and the commands its fields ask for. No controls. */
internal class InspectorViewModel(private val session: EditorSession) {
    private var spreadSpacing = ""
    private var spreadRatio = "1"

    val title: String
        get() {
            val picked = session.selection
            return when {
                picked.onlyShape >= 0 -> ShapeFields.title(session.document.path, picked.onlyShape)
                picked.nodes.size == 1 -> "Node ${picked.nodes.first()}"
                picked.nodes.isNotEmpty() -> "${picked.nodes.size} nodes"
                picked.shapes.isNotEmpty() -> "${picked.shapes.size} shapes"
                picked.loops.size == 1 -> "Loop ${picked.loops.first() + 1}"
                picked.loops.isNotEmpty() -> "${picked.loops.size} loops"
                else -> "New shapes"
            }
        }

    /** One sentence below the title. */
    val note: String
        get() {
            val picked = session.selection
            val path = session.document.path
            return when {
                picked.isEmpty -> "What the next shape is exploded with. Click a shape to change it."
                picked.onlyShape >= 0 && !path.isLinked(picked.onlyShape) ->
                    "Nodes of this shape were edited. A change here explodes it anew and drops those edits."
                else -> ""
            }
        }

    val sections: List<InspectorSection>
        get() {
            val picked = session.selection
            return when {
                picked.nodes.isNotEmpty() -> nodeSections(picked.nodes)
                picked.shapes.isNotEmpty() -> shapeSections(picked.shapes)
                picked.loops.isNotEmpty() -> loopSections(picked.loops)
                else -> listOf(InspectorSection("Spacing", defaultFields())) + PictureFields.of(session.document)
            }
        }

    /** Where the nodes of a line from 0 to 1 would lie with the spacing law that is shown; for the small picture of it. */
    val distributionPreview: DoubleArray
        get() {
            val shape = session.selection.shapes.firstOrNull()?.let { session.document.path.shape(it) }
            val defaults = session.document.project.defaults
            val line = Line(0.0, 0.0, 1.0, 0.0, PREVIEW_SPACING)
                .withRatio(shape?.ratio ?: defaults.ratio).withDistribution(shape?.distribution ?: defaults.distribution)
            return try {
                val xy = line.explode()
                DoubleArray(xy.size / 2) { xy[2 * it] }
            } catch (_: TriGridException) {
                DoubleArray(0)
            }
        }

    /** Does what [text] in [field] asks for. @return what is wrong with it, or null. */
    fun commit(field: InspectorField, text: String): String? {
        val change = field.change ?: return null
        if (text == field.value) return null
        val command = try {
            change(text)
        } catch (error: IllegalArgumentException) {
            return error.message
        } catch (error: TriGridException) {
            return error.message
        }
        return if (session.execute(command)) null else session.message
    }

    private fun shapeSections(shapes: Set<Int>): List<InspectorSection> {
        val path = session.document.path
        val first = path.shape(shapes.first())
        val sections = ArrayList<InspectorSection>()
        if (shapes.size == 1) {
            val role = ShapeRole.of(session.document, shapes.first())
            val fields = if (role.isEmpty()) emptyList() else listOf(InspectorField("Role", role))
            sections.add(InspectorSection("Geometry", fields + ShapeFields.geometry(path, shapes.first(), first)))
        }
        val all = shapes.map { path.shape(it) }
        sections.add(InspectorSection("Spacing", spacingFields(shapes, all)))
        sections.add(InspectorSection("Boundary group", listOf(nameField(shapes, all))))
        return sections
    }

    private fun spacingFields(shapes: Set<Int>, all: List<Shape>): List<InspectorField> {
        val nodes = shapes.sumOf { session.document.path.nodesOf(it).size }
        return listOf(
            shared(shapes, all, "Spacing", "length", "Wanted distance of neighbouring nodes", { Figures.exact(it.spacing) }) { shape, text ->
                shape.withSpacing(FieldNumbers.positive(text))
            },
            shared(shapes, all, "Ratio", "last : first", "Last spacing over first; 1 for even ones", { Figures.exact(it.ratio) }) { shape, text ->
                shape.withRatio(FieldNumbers.positive(text))
            },
            InspectorField("Distribution", common(all) { words(it.distribution) }, choices = Distribution.entries.map { words(it) }) { text ->
                ChangeShapes(shapes, "distribution") { it.withDistribution(Distribution.entries.first { d -> words(d) == text }) }
            },
            InspectorField("Rounding", common(all) { words(it.rounding) }, choices = Rounding.entries.map { words(it) }) { text ->
                ChangeShapes(shapes, "rounding") { it.withRounding(Rounding.entries.first { r -> words(r) == text }) }
            },
            InspectorField("Nodes", Figures.count(nodes)),
        )
    }

    private fun nameField(shapes: Set<Int>, all: List<Shape>): InspectorField =
        shared(shapes, all, "Name", "", "Physical group of the mesh file; empty for the unnamed boundary", { it.name }) { shape, text ->
            shape.withName(text.trim())
        }

    private fun shared(
        shapes: Set<Int>,
        all: List<Shape>,
        label: String,
        unit: String,
        help: String,
        value: (Shape) -> String,
        change: (Shape, String) -> Shape,
    ) = InspectorField(label, common(all, value), unit, help = help) { text ->
        all.forEach { change(it, text) }
        ChangeShapes(shapes, label.lowercase(), "$label $shapes") { change(it, text) }
    }

    private fun common(all: List<Shape>, value: (Shape) -> String): String = all.map(value).distinct().singleOrNull() ?: ""

    private fun nodeSections(picked: Set<Int>): List<InspectorSection> {
        val nodes = session.document.nodes
        if (picked.size == 1) {
            val node = picked.first()
            val fields = listOf(
                InspectorField("x", Figures.exact(nodes.x(node)), "length") { moved(node, FieldNumbers.any(it), nodes.y(node)) },
                InspectorField("y", Figures.exact(nodes.y(node)), "length") { moved(node, nodes.x(node), FieldNumbers.any(it)) },
            )
            return listOf(InspectorSection("Place", fields))
        }
        if (picked.size != 2) return emptyList()
        val (a, b) = picked.sorted()
        val distance = nodes.point(a).distanceTo(nodes.point(b))
        val fields = listOf(
            InspectorField("Distance", Figures.length(distance), "length"),
            InspectorField("New spacing", spreadSpacing, "length", help = "Spreads the nodes between the two anew on the straight line between them") {
                spreadSpacing = it
                SpreadNodes(a, b, FieldNumbers.positive(it), FieldNumbers.positive(spreadRatio))
            },
            InspectorField("Ratio", spreadRatio, "last : first") {
                spreadRatio = it
                SpreadNodes(a, b, FieldNumbers.positive(spreadSpacing.ifBlank { Figures.exact(distance) }), FieldNumbers.positive(it))
            },
        )
        return listOf(InspectorSection("Spread nodes between", fields))
    }

    private fun moved(node: Int, x: Double, y: Double): EditCommand = MoveNodes(intArrayOf(node), listOf(Point2(x, y)), "place of $node")

    private fun loopSections(picked: Set<Int>): List<InspectorSection> {
        val loops = picked.map { session.document.loops[it] }
        val name = loops.flatMap { it.segmentTags }.distinct().singleOrNull() ?: ""
        return listOf(
            InspectorSection("Loop", listOf(InspectorField("Nodes", Figures.count(loops.sumOf { it.nodeCount })))),
            InspectorSection(
                "Boundary group",
                listOf(InspectorField("Name", name, help = "Physical group of the mesh file") { ProjectCommands.nameLoops(picked, it.trim()) }),
            ),
        )
    }

    private fun defaultFields(): List<InspectorField> {
        val d = session.document.project.defaults
        return listOf(
            InspectorField("Spacing", Figures.exact(d.spacing), "length", help = "Wanted distance of neighbouring nodes") {
                defaults("spacing", ShapeDefaults(FieldNumbers.positive(it), d.ratio, d.distribution, d.rounding))
            },
            InspectorField("Ratio", Figures.exact(d.ratio), "last : first", help = "Last spacing over first; 1 for even ones") {
                defaults("ratio", ShapeDefaults(d.spacing, FieldNumbers.positive(it), d.distribution, d.rounding))
            },
            InspectorField("Distribution", words(d.distribution), choices = Distribution.entries.map { words(it) }) { text ->
                defaults("distribution", ShapeDefaults(d.spacing, d.ratio, Distribution.entries.first { words(it) == text }, d.rounding))
            },
            InspectorField("Rounding", words(d.rounding), choices = Rounding.entries.map { words(it) }) { text ->
                defaults("rounding", ShapeDefaults(d.spacing, d.ratio, d.distribution, Rounding.entries.first { words(it) == text }))
            },
        )
    }

    private fun defaults(what: String, value: ShapeDefaults): EditCommand = ProjectCommands.defaults(what, value)

    private fun words(value: Enum<*>): String = value.name.lowercase().replaceFirstChar { it.uppercase() }

    private companion object {
        const val PREVIEW_SPACING = 1.0 / 12
    }
}
