package org.trigrid.editor.tool

import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection

/** What a tool may see and do. */
internal interface ToolHost {
    val state: EditorState

    val snapper: Snapper

    /** Does a command. @return whether it could be done. */
    fun execute(command: EditCommand): Boolean

    fun select(selection: Selection)

    /** The tool is done and wants to make way for the one that selects. */
    fun leaveTool()
}
