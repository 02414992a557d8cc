package org.trigrid.editor.app

import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.command.SourceCommands
import org.trigrid.editor.inspector.NumberQuestion
import org.trigrid.editor.session.EditorSession
import org.trigrid.editor.tool.PlaceTool
import org.trigrid.editor.tool.TwoPointTool

/** Places that ask for small elements: clicked, then their size typed. */
internal class SourceActions(private val session: EditorSession, private val dialogs: Dialogs) {
    fun point() = session.use(
        PlaceTool(session, "Size at a point", "Click where elements shall be small; Esc ends") { at ->
            ask { SourceCommands.addPoint(it, at.x, at.y) }
        },
    )

    fun line() = session.use(
        TwoPointTool(session, "Size along a line", "Click the begin of the line along which elements shall be small; Esc ends", "Click its end") { a, b ->
            ask { SourceCommands.addLine(it, a.x, a.y, b.x, b.y) }
        },
    )

    private fun ask(command: (Double) -> EditCommand) {
        val sources = session.document.project.options.sizeSources
        val usual = if (sources.count > 0) sources.sizeOf(sources.count - 1) else session.document.project.defaults.spacing / FINER
        val size = dialogs.askForNumbers("Size of the elements there", NumberQuestion.positive("Edge length", usual))?.first() ?: return
        if (session.execute(command(size))) session.say("The tab Options lists it; an empty field there removes it. Long segments of the boundary nearby keep elements larger")
    }

    private companion object {
        /** By how much the first source is finer than the boundary, as a proposal. */
        const val FINER = 4
    }
}
