package org.trigrid.domain

/** What a loop bounds. */
public enum class LoopRole {
    /** The domain lies inside. */
    OUTER,

    /** The domain lies outside. */
    HOLE,
}
