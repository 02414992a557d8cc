package org.trigrid.editor.canvas

/** Colours of a mesh, 0xAARRGGBB, opaque. */
internal class MeshInk(
    val fill: Int,
    val line: Int,
    /** Of lines between coloured elements. */
    val lineOnColour: Int,
) {
    companion object {
        val LIGHT = MeshInk(0xFFE9F0F6.toInt(), 0xFF5B7186.toInt(), 0xFF14263C.toInt())
        val DARK = MeshInk(0xFF233140.toInt(), 0xFF8FA5BA.toInt(), 0xFF050A10.toInt())
    }
}
