package org.trigrid.editor.session

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.command.AddShapes
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection
import org.trigrid.editor.files.PointList
import org.trigrid.project.NodeLoop
import org.trigrid.project.ProjectFile
import org.trigrid.shape.Shape
import org.trigrid.shape.Similarity

/** Shapes and loops away from a document, on their way to be pasted. Immutable. */
internal class Clip(val shapes: List<Shape>, val loops: List<NodeLoop>) {
    val isEmpty: Boolean get() = shapes.isEmpty() && loops.isEmpty()

    /** As the text of a project, so that other windows can paste it. */
    fun toText(): String =
        ProjectFile.format(AddShapes(shapes, loops, "copy").apply(EditorState(EditorDocument.EMPTY)).document.project)

    fun moved(similarity: Similarity): Clip =
        Clip(shapes.map { similarity.apply(it) }, loops.map { TransformSelection.moved(it, similarity) })

    companion object {
        /** What is picked; without connectors, which elsewhere would be lines of the boundary, and openings do without. */
        fun of(document: EditorDocument, selection: Selection): Clip = Clip(
            selection.shapes.sorted().filter { !document.path.isConnector(it) }.map { document.path.shape(it) },
            selection.loops.sorted().map { document.loops[it] },
        )

        /** What [text] holds: a project, or a list of points; null if it is neither. */
        fun parse(text: String): Clip? {
            PointList.parse(text)?.let { loops -> return Clip(emptyList(), loops.map { NodeLoop(it, "boundary") }) }
            return try {
                val project = ProjectFile.parse(text, "clipboard")
                Clip((0 until project.path.shapeCount).map { project.path.shape(it) }, project.loops)
            } catch (_: TriGridException) {
                null
            }
        }
    }
}
