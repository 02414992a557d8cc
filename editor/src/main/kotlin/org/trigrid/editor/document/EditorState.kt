package org.trigrid.editor.document

/** A document and what is picked in it. Immutable. */
internal class EditorState(val document: EditorDocument, selection: Selection = Selection.NONE) {
    val selection: Selection = selection.within(document)

    fun withSelection(value: Selection): EditorState = EditorState(document, value)
}
