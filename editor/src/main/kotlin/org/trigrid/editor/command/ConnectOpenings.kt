package org.trigrid.editor.command

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection

/** Joins openings, by the numbers of their walks, to the path by two-way connectors along the shortest free lines. */
internal class ConnectOpenings(private val openings: List<Int>) : EditCommand {
    override val name: String = if (openings.size == 1) "connect opening" else "connect ${openings.size} openings"

    override fun apply(state: EditorState): EditorState {
        var project = state.document.project
        // A walk that is joined to another is no longer counted, so the last goes first.
        for (opening in openings.sortedDescending()) project = project.connectOpening(opening, project.defaults.spacing)
        return EditorState(EditorDocument(project), Selection(shapes = (state.document.path.shapeCount until project.path.shapeCount).toSet()))
    }

    companion object {
        /** The openings without a connector that [selection] touches; all of them where nothing is picked. */
        fun of(document: EditorDocument, selection: Selection): List<Int> {
            val openings = try {
                document.project.openings().toList()
            } catch (_: TriGridException) {
                emptyList()
            }
            if (selection.isEmpty) return openings
            val walks = document.path.walks()
            return openings.filter { opening ->
                val walk = walks[opening]
                (0 until walk.stepCount).any { walk.shape(it) in selection.shapes } || walk.nodes().any { it in selection.nodes }
            }
        }
    }
}
