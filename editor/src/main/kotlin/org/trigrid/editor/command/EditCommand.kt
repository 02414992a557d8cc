package org.trigrid.editor.command

import org.trigrid.editor.document.EditorState

/** One change of the document, with a name that people read after "Undo". */
internal interface EditCommand {
    val name: String

    /** Commands with equal keys that follow one another are one step, as those of one drag; null never merges. */
    val mergeKey: Any? get() = null

    /**
     * The state after the change.
     *
     * @throws org.trigrid.diagnostics.TriGridException if the change makes no valid document; nothing has changed then.
     */
    fun apply(state: EditorState): EditorState

    companion object {
        /** A command that is told what to do. */
        fun of(name: String, mergeKey: Any? = null, change: (EditorState) -> EditorState): EditCommand =
            object : EditCommand {
                override val name = name
                override val mergeKey = mergeKey

                override fun apply(state: EditorState): EditorState = change(state)
            }
    }
}
