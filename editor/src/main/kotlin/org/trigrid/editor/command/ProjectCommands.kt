package org.trigrid.editor.command

import org.trigrid.MeshOptions
import org.trigrid.domain.Domain
import org.trigrid.domain.Path
import org.trigrid.editor.document.EditorState
import org.trigrid.project.Background
import org.trigrid.project.NodeLoop
import org.trigrid.project.ShapeDefaults

/** Changes of what is not drawn: options, names, defaults, the picture behind. */
internal object ProjectCommands {
    fun options(what: String, options: MeshOptions): EditCommand =
        EditCommand.of("change $what", "options $what") { keeping(it) { document -> document.with { options(options) } } }

    fun defaults(what: String, defaults: ShapeDefaults): EditCommand =
        EditCommand.of("change default $what", "defaults $what") { keeping(it) { document -> document.with { defaults(defaults) } } }

    fun keepConnectors(value: Boolean): EditCommand =
        EditCommand.of(if (value) "keep connectors" else "drop connectors") { state ->
            if (state.document.project.keepsConnectors == value) state else keeping(state) { it.with { keepConnectors(value) } }
        }

    fun regionName(value: String): EditCommand = EditCommand.of("rename region", "region name") { state ->
        val project = state.document.project
        val colours = recoloured(project.colours, project.regionName, value)
        if (project.regionName == value) state else keeping(state) { it.with { regionName(value).colours(colours) } }
    }

    /** A colour goes along with its name, unless the new name has one. */
    private fun recoloured(colours: Map<String, String>, from: String, to: String): Map<String, String> {
        val colour = colours[from] ?: return colours
        val changed = LinkedHashMap(colours)
        changed.remove(from)
        changed.putIfAbsent(to, colour)
        return changed
    }

    /** Gives the boundary group [from] another name, wherever it occurs. */
    fun renameGroup(from: String, to: String): EditCommand = EditCommand.of("rename group") { state ->
        if (from == to) return@of state
        val document = state.document
        var path = document.path
        for (shape in 0 until path.shapeCount) {
            val name = path.shape(shape).name.ifEmpty { Path.UNNAMED_TAG }
            if (name == from) path = path.replaceShape(shape, path.shape(shape).withName(to))
        }
        val loops = document.loops.map { loop ->
            if (from !in loop.segmentTags) loop else NodeLoop(loop.coordinates(), loop.segmentTags.map { if (it == from) to else it })
        }
        val colours = recoloured(document.project.colours, from, to)
        EditorState(document.with { path(path).loops(loops).colours(colours) }, state.selection)
    }

    /** Gives a boundary group or the region a colour, `#rrggbb`; null for the one it has by itself. */
    fun colour(name: String, colour: String?): EditCommand = EditCommand.of("colour of $name", "colour $name") { state ->
        val colours = LinkedHashMap(state.document.project.colours)
        if (colour == null) colours.remove(name) else colours[name] = colour
        if (colours == state.document.project.colours) state else keeping(state) { it.with { colours(colours) } }
    }

    /** Gives all segments of picked loops one boundary group. */
    fun nameLoops(loops: Set<Int>, name: String): EditCommand = EditCommand.of("name group", "name loops") { state ->
        keeping(state) { document ->
            document.withLoops(document.loops.mapIndexed { i, loop -> if (i in loops) NodeLoop(loop.coordinates(), name) else loop })
        }
    }

    /** Adds the loops of [domain] as loops of plain nodes. */
    fun addDomain(domain: Domain, what: String): EditCommand = AddShapes(emptyList(), loopsOf(domain), "import $what")

    fun picture(name: String, picture: Background?, mergeKey: Any? = null): EditCommand =
        EditCommand.of(name, mergeKey) { keeping(it) { document -> document.withPicture(picture) } }

    fun loopsOf(domain: Domain): List<NodeLoop> = (0 until domain.loopCount).map { loop ->
        val nodes = domain.loopNodes(loop)
        val start = domain.loopStart(loop)
        NodeLoop(
            DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) },
            nodes.indices.map { domain.tags[domain.segmentTag(start + it)] },
        )
    }

    private fun keeping(
        state: EditorState,
        change: (org.trigrid.editor.document.EditorDocument) -> org.trigrid.editor.document.EditorDocument,
    ): EditorState = EditorState(change(state.document), state.selection)
}
