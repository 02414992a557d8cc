package org.trigrid.editor.command

import org.trigrid.editor.document.EditorState
import org.trigrid.spacing.SizeSources

/** Changes of the places that ask for small elements. */
internal object SourceCommands {
    fun addPoint(size: Double, x: Double, y: Double): EditCommand = changing("add size at a point") { it.withPoint(size, x, y) }

    fun addLine(size: Double, vararg coordinates: Double): EditCommand = changing("add size along a line") { it.withLine(size, *coordinates) }

    /** Another size at a source; null removes it. */
    fun resize(source: Int, size: Double?): EditCommand = changing(if (size == null) "remove size source" else "change size source") { all ->
        (0 until all.count).fold(SizeSources.NONE) { kept, i ->
            val wanted = if (i == source) size else all.sizeOf(i)
            val place = all.placeOf(i)
            if (wanted == null) kept else if (place.size == 2) kept.withPoint(wanted, place[0], place[1]) else kept.withLine(wanted, *place)
        }
    }

    private fun changing(name: String, change: (SizeSources) -> SizeSources): EditCommand = EditCommand.of(name) { state ->
        val options = state.document.project.options
        EditorState(state.document.with { options(options.toBuilder().sizeSources(change(options.sizeSources)).build()) }, state.selection)
    }
}
