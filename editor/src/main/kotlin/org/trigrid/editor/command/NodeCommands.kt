package org.trigrid.editor.command

import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.NodeEdits
import org.trigrid.editor.document.Outline
import org.trigrid.editor.document.Selection
import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Similarity

/** Moves nodes to given places; one put onto another merges with it. */
internal class MoveNodes(
    private val nodes: IntArray,
    private val places: List<Point2>,
    override val mergeKey: Any? = null,
) : EditCommand {
    override val name: String = if (nodes.size == 1) "move node" else "move ${nodes.size} nodes"

    override fun apply(state: EditorState): EditorState {
        val all = state.document.nodes
        val stays = nodes.indices.all { all.x(nodes[it]) == places[it].x && all.y(nodes[it]) == places[it].y }
        if (stays) return state
        val moved = NodeEdits.move(state.document, nodes, places)
        val selection = if (moved.nodes.count == all.count) state.selection else Selection.NONE
        return EditorState(moved, selection)
    }
}

/** A new node between two neighbours, picked. */
internal class InsertNode(private val from: Int, private val to: Int, private val point: Point2) : EditCommand {
    override val name: String = "insert node"

    override fun apply(state: EditorState): EditorState {
        val document = NodeEdits.insert(state.document, from, to, point)
        return EditorState(document, Selection.ofNode(NodeEdits.insertedNumber(from)))
    }
}

/**
 * Spreads the nodes between two nodes of one walk or loop anew, along the straight line between them.
 *
 * Of the two ways round a loop the shorter, by nodes, is taken.
 */
internal class SpreadNodes(
    private val from: Int,
    private val to: Int,
    private val spacing: Double,
    private val ratio: Double,
) : EditCommand {
    override val name: String = "spread nodes"

    override fun apply(state: EditorState): EditorState {
        var document = state.document
        val between = NodeCommands.between(document, from, to) ?: return state
        val first = document.nodes.point(between.first())
        val last = document.nodes.point(between.last())
        val wanted = Line(first, last, spacing).withRatio(ratio).explode()
        val inner = (1 until wanted.size / 2 - 1).map { Point2(wanted[2 * it], wanted[2 * it + 1]) }
        document = NodeEdits.delete(document, between.subList(1, between.size - 1).toSet())
        var at = document.nodes.at(first.x, first.y)
        val end = document.nodes.at(last.x, last.y)
        require(at >= 0 && end >= 0) { "The way between the two nodes comes back on itself; pick two nearer ones" }
        var next = end
        for (point in inner) {
            document = NodeEdits.insert(document, at, next, point)
            at++
            if (next >= at) next++
        }
        return EditorState(document)
    }
}

internal object NodeCommands {
    fun deleted(document: EditorDocument, nodes: Set<Int>): EditorDocument = NodeEdits.delete(document, nodes)

    fun moved(state: EditorState, nodes: Set<Int>, similarity: Similarity): EditorState {
        val numbers = nodes.toIntArray()
        return MoveNodes(numbers, numbers.map { similarity.apply(state.document.nodes.point(it)) }).apply(state)
    }

    /** The nodes from one to another along the walk or loop that has both, in the order of travel; null if none has. */
    fun between(document: EditorDocument, a: Int, b: Int): List<Int>? {
        val outline = document.outlines.firstOrNull { a in it.nodes && b in it.nodes } ?: return null
        val forward = run(outline, a, b)
        val backward = run(outline, b, a)
        return when {
            forward == null -> backward
            backward == null || forward.size <= backward.size -> forward
            else -> backward
        }
    }

    private fun run(outline: Outline, a: Int, b: Int): List<Int>? {
        val nodes = outline.nodes
        val begin = nodes.indexOf(a)
        val found = ArrayList<Int>()
        for (k in nodes.indices) {
            val i = begin + k
            if (i >= nodes.size && !outline.isClosed) return null
            found.add(nodes[i % nodes.size])
            if (found.last() == b) return found
        }
        return null
    }
}
