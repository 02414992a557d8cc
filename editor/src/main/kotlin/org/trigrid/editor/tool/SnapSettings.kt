package org.trigrid.editor.tool

/** What the mouse is drawn to. Immutable. */
internal class SnapSettings(
    val toGrid: Boolean = true,
    val toNodes: Boolean = true,
    val toShapes: Boolean = true,
    /** Held by Shift, in degrees. */
    val angleStep: Double = 15.0,
) {
    fun withGrid(value: Boolean): SnapSettings = SnapSettings(value, toNodes, toShapes, angleStep)

    fun withNodes(value: Boolean): SnapSettings = SnapSettings(toGrid, value, toShapes, angleStep)

    fun withShapes(value: Boolean): SnapSettings = SnapSettings(toGrid, toNodes, value, angleStep)
}
