package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/**
 * What the mouse and the keys mean at the moment. A state machine that knows nothing of windows: it is told of places
 * in the domain's coordinates and answers with a preview, a hint and commands to its host.
 */
internal interface Tool {
    val label: String

    /** What to do next, for the foot of the window. */
    val hint: String

    val preview: Preview

    /** The point that `@` in typed coordinates counts from, or null. */
    val lastPoint: Point2? get() = null

    fun move(input: PointerInput) {}

    fun press(input: PointerInput) {}

    fun drag(input: PointerInput) {}

    fun release(input: PointerInput) {}

    /** A place that was typed; as a click there. */
    fun typed(point: Point2) {}

    /** @return whether the key meant something, as of all keys below. */
    fun enter(): Boolean = false

    fun backspace(): Boolean = false

    fun cancel(): Boolean = false

    /** Up and down: more and fewer of what the tool counts. */
    fun count(change: Int): Boolean = false

    /** The document was changed by others, as by undo. */
    fun documentChanged() {}
}
