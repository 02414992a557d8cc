package org.trigrid.editor.tool

import org.trigrid.editor.command.EditCommand
import org.trigrid.editor.document.EditorState
import org.trigrid.editor.document.Selection
import org.trigrid.geometry.Point2

/** What a tool may see and do. */
internal interface ToolHost {
    val state: EditorState

    val snapper: Snapper

    /** Pixels of the picture behind in width and height, or null where none is shown. */
    val pictureSize: Point2? get() = null

    /** Does a command. @return whether it could be done. */
    fun execute(command: EditCommand): Boolean

    fun select(selection: Selection)

    /** The tool is done and wants to make way for the one that selects. */
    fun leaveTool()
}
