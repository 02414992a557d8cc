package org.trigrid.shape

/** The shapes of the paper, each with a text form of its own; see [PaperText]. */
public enum class PaperShape {
    LINE,
    LINES,
    CURVE,
    RECTANGLE,
    POLYGON,
    CIRCLE,
    ELLIPSE,
}
