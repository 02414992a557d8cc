package org.trigrid.editor.session

import org.trigrid.editor.tool.PointerInput
import org.trigrid.editor.tool.ShapeKind

/** A session whose background work is done at once. */
internal fun newSession(): EditorSession = EditorSession({ it.run() }, { it.run() })

/** A click as the mouse makes it, a pixel being a hundredth. */
internal fun EditorSession.click(x: Double, y: Double, count: Int = 1, shift: Boolean = false, alt: Boolean = false) {
    val input = PointerInput(x, y, PIXEL, shift, alt, clickCount = count)
    move(input)
    press(input)
    release(input)
}

internal fun EditorSession.dragFrom(fromX: Double, fromY: Double, toX: Double, toY: Double, alt: Boolean = false) {
    press(PointerInput(fromX, fromY, PIXEL, isAltDown = alt))
    for (k in 1..4) drag(PointerInput(fromX + (toX - fromX) * k / 4, fromY + (toY - fromY) * k / 4, PIXEL, isAltDown = alt))
    release(PointerInput(toX, toY, PIXEL, isAltDown = alt))
}

/** Draws with a tool by clicks at x0, y0, x1, y1, … */
internal fun EditorSession.drawWith(kind: ShapeKind, vararg xy: Double) {
    draw(kind)
    for (i in xy.indices step 2) click(xy[i], xy[i + 1])
}

internal const val PIXEL = 0.01
