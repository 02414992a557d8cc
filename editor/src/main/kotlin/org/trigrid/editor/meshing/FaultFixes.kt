package org.trigrid.editor.meshing

import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.TriGridException
import org.trigrid.domain.DomainCheck
import org.trigrid.domain.Path
import org.trigrid.editor.command.DeleteSelection
import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.command.MoveNodes
import org.trigrid.editor.command.ReplaceShape
import org.trigrid.editor.command.ShapeCommands
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.NodeEdits
import org.trigrid.editor.document.Picking
import org.trigrid.editor.document.Selection
import org.trigrid.editor.document.ShapeEdits
import org.trigrid.geometry.Point2

/** What mends a fault, as a step that can be undone. */
internal object FaultFixes {
    /** A command that mends [fault], or null where people have to see for themselves. */
    fun of(document: EditorDocument, fault: Fault): EditCommand? = when (fault.kind) {
        FaultKind.OPEN_WALK -> snapEnds(document, fault) ?: ShapeCommands.closeLoop().takeIf { document.path.walks().lastOrNull()?.isClosed == false }
        FaultKind.CROSSING -> splitAt(Point2(fault.x, fault.y), "split at the crossing")
        FaultKind.TOUCHING -> splitAt(Point2(fault.x, fault.y), "join the node to the line")
        FaultKind.SPIKE, FaultKind.ZERO_LENGTH, FaultKind.DUPLICATE_NODE -> removeNode(document, fault)
        FaultKind.OVERLAP -> removeDuplicate(document, fault)
        FaultKind.HOLE_OUTSIDE -> turnLoop(fault)
        FaultKind.NOT_A_NUMBER, FaultKind.DEGENERATE_LOOP, FaultKind.EMBEDDED_OUTSIDE, FaultKind.REGION_POINT -> null
    }

    /** Where the ends of an open walk nearly meet the later one goes onto the other. */
    private fun snapEnds(document: EditorDocument, fault: Fault): EditCommand? {
        val (first, last) = fault.nodes().takeIf { it.size == 2 } ?: return null
        val path = document.path
        if (last >= path.nodeCount || first >= path.nodeCount) return null
        val nearest = document.project.defaults.spacing * NEARLY
        if (path.node(first).distanceTo(path.node(last)) > nearest) return null
        val command = shapeEndingAt(path, path.node(last))?.let { shape ->
            ShapeEdits.endedAt(path.shape(shape), path.node(first))?.let { ReplaceShape(shape, it, "end") }
        }
        return Named("snap the ends together", command ?: MoveNodes(intArrayOf(last), listOf(path.node(first))))
    }

    private fun shapeEndingAt(path: Path, end: Point2): Int? = (0 until path.shapeCount).lastOrNull {
        path.isLinked(it) && !path.isConnector(it) && !path.shape(it).isClosed() && path.shape(it).lastPoint == end
    }

    /** Turns the loop round that runs the wrong way: the one whose turning leaves the fewest faults. */
    private fun turnLoop(fault: Fault): EditCommand = EditCommand.of("turn the loop round") { state ->
        val path = state.document.path
        val walks = path.walks().filter { walk -> walk.isClosed && walk.nodes().any { path.x(it) == fault.x && path.y(it) == fault.y } }
        val turned = walks.mapNotNull { walk ->
            val own = walk.nodes().firstOrNull { node -> walks.none { it !== walk && node in it.nodes() } }
            own?.let { state.document.withPath(path.turnWalk(it)) }
        }
        turned.minByOrNull { faultsOf(it) }?.let { EditorState(it) } ?: state
    }

    private fun faultsOf(document: EditorDocument): Int = try {
        DomainCheck.check(document.project.toDomain()).size
    } catch (_: TriGridException) {
        Int.MAX_VALUE
    }

    /** A node on every segment that runs through the place, so that they meet there. */
    private fun splitAt(place: Point2, name: String): EditCommand = EditCommand.of(name) { state ->
        var document = state.document
        var isChanged = true
        var rounds = 0
        while (isChanged && rounds++ < MOST_SEGMENTS) {
            isChanged = false
            val through = through(document, place) ?: break
            document = NodeEdits.insert(document, through.first, through.second, place)
            isChanged = true
        }
        if (document === state.document) state else EditorState(document)
    }

    private fun through(document: EditorDocument, place: Point2): Pair<Int, Int>? {
        val nodes = document.nodes
        for (outline in document.outlines) {
            for (step in 0 until outline.stepCount) {
                val a = nodes.point(outline.nodes[step])
                val b = nodes.point(outline.stepEnd(step))
                val length = a.distanceTo(b)
                if (a.distanceTo(place) <= NEAR * length || b.distanceTo(place) <= NEAR * length) continue
                val foot = Picking.nearest(a, b, place.x, place.y)
                if (foot.distanceTo(place) <= NEAR * length) return outline.nodes[step] to outline.stepEnd(step)
            }
        }
        return null
    }

    private fun removeNode(document: EditorDocument, fault: Fault): EditCommand? {
        val node = document.nodes.at(fault.x, fault.y)
        if (node < 0) return null
        return Named("delete the node", DeleteSelection(Selection.ofNode(node)))
    }

    /** Of two shapes that lie on one another the later one goes. */
    private fun removeDuplicate(document: EditorDocument, fault: Fault): EditCommand? {
        val path = document.path
        for (shape in path.shapeCount - 1 downTo 1) {
            if (path.isConnector(shape)) continue
            for (earlier in 0 until shape) {
                val alike = path.shape(shape) == path.shape(earlier) || path.shape(shape).reversed() == path.shape(earlier)
                if (alike) return Named("remove the duplicate", DeleteSelection(Selection.ofShape(shape)))
            }
        }
        return null.also { check(fault.kind == FaultKind.OVERLAP) }
    }

    private class Named(override val name: String, private val command: EditCommand) : EditCommand {
        override fun apply(state: EditorState): EditorState = command.apply(state)
    }

    /** Share of a segment's length within which a place lies on it: rounding of the crossing point, amply. */
    private const val NEAR = 1e-9

    /** Share of the spacing within which two ends were meant to be one. */
    private const val NEARLY = 0.5
    private const val MOST_SEGMENTS = 16
}
