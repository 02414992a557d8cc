package org.trigrid.editor.app

import org.trigrid.editor.tool.ShapeKind

/** All keys on one sheet. */
internal object KeySheet {
    fun text(): String = buildString {
        appendLine("Tools: V select, Shift+V lasso")
        appendLine(ShapeKind.entries.joinToString(", ") { "${it.key} ${it.label.lowercase()}" })
        appendLine()
        appendLine("Enter or double click ends a shape, Backspace takes the last point back, Esc cancels.")
        appendLine("Shift holds angles, Alt suspends snapping.")
        appendLine("Type a place at any moment: 3,4   @1,0   @2<30")
        appendLine("Arrow keys move what is picked by a step of the grid.")
        appendLine("Double click on a line inserts a node; drop a node on another to merge them.")
        appendLine()
        appendLine("Wheel zooms at the mouse; right or middle button, or Space and drag, move the sheet.")
        appendLine("While the front is played: Space plays and pauses, Left and Right step, Esc ends.")
        append("Ctrl+K connects openings, Shift+F6 plays the front, F4 problems, F5 mesh, F6 matrix, F7 mesh shown, F8 nodes, F9 numbers")
    }
}
