package org.trigrid.editor.tool

/**
 * Where the mouse is and what is held down.
 *
 * @param pixel size of a pixel of the screen, in the domain's unit.
 */
internal class PointerInput(
    val x: Double,
    val y: Double,
    val pixel: Double,
    val isShiftDown: Boolean = false,
    val isAltDown: Boolean = false,
    val isControlDown: Boolean = false,
    val clickCount: Int = 1,
)
