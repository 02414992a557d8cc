package org.trigrid.domain

/** The kinds of [DomainWarning]. */
public enum class WarningKind {
    /** Two stretches of one loop are closer than the segments there are long: flat elements between them. */
    NARROW_GAP,

    /** Two loops are closer than the segments there are long: flat elements between them. */
    CLOSE_LOOPS,

    /** The domain's angle at a node is below 5°. */
    SHARP_ANGLE,

    /** One of two successive segments is more than three times as long as the other. */
    SPACING_JUMP,
}
