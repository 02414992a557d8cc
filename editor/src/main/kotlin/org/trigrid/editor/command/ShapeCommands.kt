package org.trigrid.editor.command

import org.trigrid.domain.Path
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection
import org.trigrid.editor.document.ShapeEdits
import org.trigrid.project.NodeLoop
import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Shape
import org.trigrid.shape.Similarity

/** Appends a shape to the path and picks it. */
internal class AppendShape(private val shape: Shape, kind: String) : EditCommand {
    override val name: String = "draw $kind"

    override fun apply(state: EditorState): EditorState {
        val path = ShapeEdits.append(state.document.path, shape)
        return EditorState(state.document.withPath(path))
    }
}

/** Appends a line that will be travelled back, so that what is drawn at its end hangs on it. */
internal class AppendConnector(private val line: Line) : EditCommand {
    override val name: String = "draw connector"

    override fun apply(state: EditorState): EditorState =
        EditorState(state.document.withPath(state.document.path.appendConnector(line)))
}

/** Another shape in place of one; its neighbours follow. */
internal class ReplaceShape(
    private val shape: Int,
    private val by: Shape,
    what: String,
    override val mergeKey: Any? = null,
) : EditCommand {
    override val name: String = "change $what"

    override fun apply(state: EditorState): EditorState {
        val path = state.document.path
        if (path.shape(shape) == by) return state
        return EditorState(state.document.withPath(ShapeEdits.replace(path, shape, by)), state.selection)
    }
}

/** The same change of several shapes, as of their spacing. */
internal class ChangeShapes(
    private val shapes: Set<Int>,
    what: String,
    override val mergeKey: Any? = null,
    private val change: (Shape) -> Shape,
) : EditCommand {
    override val name: String = "change $what"

    override fun apply(state: EditorState): EditorState {
        val path = shapes.fold(state.document.path) { path, shape ->
            val changed = change(path.shape(shape))
            if (changed == path.shape(shape)) path else ShapeEdits.replace(path, shape, changed)
        }
        return if (path === state.document.path) state else EditorState(state.document.withPath(path), state.selection)
    }
}

/** Removes what is picked: nodes where nodes are picked, else shapes and loops. */
internal class DeleteSelection(selection: Selection) : EditCommand {
    private val picked = selection

    override val name: String = when {
        picked.nodes.size == 1 -> "delete node"
        picked.nodes.isNotEmpty() -> "delete ${picked.nodes.size} nodes"
        picked.shapes.size + picked.loops.size == 1 -> "delete shape"
        else -> "delete ${picked.shapes.size + picked.loops.size} shapes"
    }

    override fun apply(state: EditorState): EditorState {
        val document = state.document
        if (picked.isEmpty) return state
        if (picked.nodes.isNotEmpty()) return EditorState(NodeCommands.deleted(document, picked.nodes))
        var path = document.path
        for (shape in picked.shapes.sortedDescending()) path = path.removeShape(shape)
        return EditorState(document.with { path(path).loops(document.loops.filterIndexed { i, _ -> i !in picked.loops }) })
    }
}

/** Moves, turns, scales or mirrors what is picked. */
internal class TransformSelection(
    private val similarity: Similarity,
    override val name: String,
    override val mergeKey: Any? = null,
) : EditCommand {
    override fun apply(state: EditorState): EditorState {
        val picked = state.selection
        if (picked.nodes.isNotEmpty()) return NodeCommands.moved(state, picked.nodes, similarity)
        if (picked.isEmpty) return state
        val document = state.document
        val path = ShapeEdits.transform(document.path, picked.shapes, similarity)
        val loops = document.loops.mapIndexed { i, loop -> if (i in picked.loops) moved(loop, similarity) else loop }
        return EditorState(document.with { path(path).loops(loops) }, picked)
    }

    companion object {
        fun moved(loop: NodeLoop, similarity: Similarity): NodeLoop {
            val xy = loop.coordinates()
            for (node in 0 until loop.nodeCount) {
                val to = similarity.apply(Point2(loop.x(node), loop.y(node)))
                xy[2 * node] = to.x
                xy[2 * node + 1] = to.y
            }
            return NodeLoop(xy, loop.segmentTags)
        }
    }
}

/** Adds shapes that hang together among themselves, as copied, in loops of their own; picks them. */
internal class AddShapes(
    private val shapes: List<Shape>,
    private val loops: List<NodeLoop>,
    override val name: String,
) : EditCommand {
    override fun apply(state: EditorState): EditorState {
        if (shapes.isEmpty() && loops.isEmpty()) return state
        val document = state.document
        val first = document.path.shapeCount
        var path = document.path
        var end: Point2? = null
        for (shape in shapes) {
            val goesOn = end != null && ShapeEdits.isAt(end, shape.firstPoint) && ShapeEdits.isWalkOpen(path)
            path = if (goesOn) path.append(shape) else begun(path, shape)
            end = path.end()
        }
        val selection = Selection(
            (first until path.shapeCount).toSet(),
            (document.loops.size until document.loops.size + loops.size).toSet(),
        )
        return EditorState(document.with { path(path).loops(document.loops + loops) }, selection)
    }

    private fun begun(path: Path, shape: Shape): Path =
        if (path.shapeCount == 0) path.append(shape) else path.newLoop().append(shape)
}

/** Commands without data of their own. */
internal object ShapeCommands {
    /** Closes the open walk by a line. */
    fun closeLoop(): EditCommand = EditCommand.of("close loop") { state ->
        val document = state.document
        val path = document.path.close(document.project.defaults.spacing)
        if (path === document.path) state else EditorState(document.withPath(path))
    }

    /** Ends the walk as it is, so that the next shape begins elsewhere. */
    fun beginLoop(): EditCommand = EditCommand.of("begin new loop") { state ->
        EditorState(state.document.withPath(state.document.path.newLoop()))
    }

    /** Travels the last connector back; nothing where there is none. */
    fun goBack(): EditCommand = EditCommand.of("go back along connector") { state ->
        try {
            EditorState(state.document.withPath(state.document.path.back()))
        } catch (_: IllegalStateException) {
            state
        }
    }

    /** Turns shapes round: what was included is left out, and the other way about. */
    fun reverse(shapes: Set<Int>): EditCommand =
        ChangeShapes(shapes, "direction") { ShapeEdits.turnedRound(it) }

    /** Drops the edits of the shapes' nodes. */
    fun rebuild(shapes: Set<Int>): EditCommand = EditCommand.of("explode anew") { state ->
        val path = shapes.fold(state.document.path) { path, shape -> path.rebuild(shape) }
        EditorState(state.document.withPath(path), state.selection)
    }

    fun clear(): EditCommand = EditCommand.of("clear") { state ->
        EditorState(state.document.with { path(Path.EMPTY).loops(emptyList()) })
    }
}
