package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/** What a tool shows over the drawing until it is done. Immutable. */
internal class Preview(
    /** Lines, each x0, y0, x1, y1, … */
    val lines: List<DoubleArray> = emptyList(),
    /** Nodes that would be made, x0, y0, x1, y1, … */
    val nodes: DoubleArray = DoubleArray(0),
    /** Lines that only help, such as a radius. */
    val guides: List<DoubleArray> = emptyList(),
    /** Two corners of a rectangle in which nodes are picked, or a lasso of more points. */
    val lasso: List<Point2> = emptyList(),
    val snap: SnapPoint? = null,
    /** Points clicked so far. */
    val marks: List<Point2> = emptyList(),
    /** Length and angle in words, or empty. */
    val measure: String = "",
) {
    companion object {
        val NOTHING = Preview()
    }
}
