package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/** What a place was drawn to, with the word for the mark beside the mouse. */
internal enum class SnapKind(val label: String) {
    NONE(""),
    GRID("grid"),
    NODE("node"),
    END("end"),
    MIDDLE("middle"),
    CENTRE("centre"),
    INTERSECTION("intersection"),
    ANGLE("angle"),
}

/** A place and what it was drawn to. */
internal class SnapPoint(val point: Point2, val kind: SnapKind, val node: Int = -1)
