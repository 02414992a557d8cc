package org.trigrid.editor.meshing

/** By what the elements of a mesh are coloured. */
internal enum class Colouring(val label: String, val unit: String) {
    NONE("Plain", ""),
    QUALITY("Quality", ""),
    MIN_ANGLE("Smallest angle", "°"),
    SIZE("Size", ""),
    DEGREE("Node degree", ""),
}
