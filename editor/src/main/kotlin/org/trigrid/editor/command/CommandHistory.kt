package org.trigrid.editor.command

import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.EditorState

/** All states since the document was opened; to undo is to go back to an earlier one. */
internal class CommandHistory(initial: EditorState) {
    private class Step(val name: String, val mergeKey: Any?, var state: EditorState)

    private val steps = arrayListOf(Step("", null, initial))
    private var at = 0
    private var savedDocument: EditorDocument = initial.document
    private var mayMerge = false
    private var isRunning = false

    val state: EditorState get() = steps[at].state

    /** Whether the document differs from the one that was saved last. */
    val isModified: Boolean get() = state.document !== savedDocument

    /** Name of the step that would be undone, or null. */
    val undoName: String? get() = if (at > 0) steps[at].name else null

    /** Name of the step that would be redone, or null. */
    val redoName: String? get() = steps.getOrNull(at + 1)?.name

    /** Names of all steps, those undone included. */
    val names: List<String> get() = steps.drop(1).map { it.name }

    /** Steps done and not undone. */
    val position: Int get() = at

    /**
     * Does [command]; what was undone before can no longer be redone.
     *
     * @return whether anything has changed.
     */
    fun execute(command: EditCommand): Boolean {
        check(!isRunning) { "a command must not start another" }
        isRunning = true
        val next = try {
            command.apply(state)
        } finally {
            isRunning = false
        }
        if (next.document === state.document) {
            steps[at].state = next
            return false
        }
        while (steps.size > at + 1) steps.removeAt(steps.size - 1)
        val last = steps[at]
        val merges = mayMerge && at > 0 && command.mergeKey != null && last.mergeKey == command.mergeKey &&
            last.state.document !== savedDocument
        if (merges) last.state = next else steps.add(Step(command.name, command.mergeKey, next))
        at = steps.size - 1
        mayMerge = true
        return true
    }

    /** Picks something else; no step of its own. */
    fun select(state: EditorState) {
        require(state.document === this.state.document) { "selecting must not change the document" }
        steps[at].state = state
    }

    /** Whatever comes next is a step of its own. */
    fun endMerging() {
        mayMerge = false
    }

    fun undo(): Boolean = goTo(at - 1)

    fun redo(): Boolean = goTo(at + 1)

    /** Goes to the state after [position] steps. */
    fun goTo(position: Int): Boolean {
        if (position !in steps.indices) return false
        at = position
        mayMerge = false
        return true
    }

    /** The document as it is now counts as saved. */
    fun markSaved(document: EditorDocument = state.document) {
        savedDocument = document
        mayMerge = false
    }

    /** The document counts as changed, as one recovered after a crash does. */
    fun markUnsaved() {
        savedDocument = NEVER
    }

    private companion object {
        val NEVER = EditorDocument(org.trigrid.project.Project.builder().build())
    }
}
