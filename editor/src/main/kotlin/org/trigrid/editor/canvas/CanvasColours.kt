package org.trigrid.editor.canvas

import javafx.scene.paint.Color
import org.trigrid.editor.document.GroupPalette

/** Colours of the sheet, for light and dark windows. */
internal class CanvasColours private constructor(
    val sheet: Color,
    val gridFine: Color,
    val gridStrong: Color,
    val axis: Color,
    val connector: Color,
    val node: Color,
    val nodeFill: Color,
    val text: Color,
    val muted: Color,
    val accent: Color,
    val fault: Color,
    val warning: Color,
    val panel: Color,
    val mesh: MeshInk,
    val palette: GroupPalette,
) {
    private val known = HashMap<String, Color>()

    /** Colour of a boundary group: the one chosen for it, or that of its place among all. */
    fun group(name: String, all: List<String>, chosen: Map<String, String>): Color =
        palette.colourOf(name, all, chosen).let { known.getOrPut(it) { Color.web(it) } }

    /** The ink of a mesh whose region was given a colour. */
    fun meshIn(region: Color?): MeshInk {
        if (region == null) return mesh
        val mixed = sheet.interpolate(region, REGION_SHARE)
        val rgb = ((255 * mixed.red).toInt() shl 16) or ((255 * mixed.green).toInt() shl 8) or (255 * mixed.blue).toInt()
        return MeshInk(0xFF000000.toInt() or rgb, mesh.line, mesh.lineOnColour)
    }

    companion object {
        /** How much of the region's colour its elements have; the lines between them must be seen. */
        private const val REGION_SHARE = 0.3

        val LIGHT = CanvasColours(
            Color.web("#ffffff"), Color.web("#eef1f4"), Color.web("#dde3e9"), Color.web("#c3ccd5"),
            Color.web("#8795a3"), Color.web("#0b5c99"), Color.web("#ffffff"), Color.web("#1b2a38"), Color.web("#66788a"),
            Color.web("#0969da"), Color.web("#cf222e"), Color.web("#9a6700"), Color.web("#ffffffe6"), MeshInk.LIGHT,
            GroupPalette.ON_LIGHT,
        )
        val DARK = CanvasColours(
            Color.web("#0d1117"), Color.web("#171d25"), Color.web("#222a34"), Color.web("#3a4552"),
            Color.web("#7d8b99"), Color.web("#79c0ff"), Color.web("#0d1117"), Color.web("#e6edf3"), Color.web("#8b98a5"),
            Color.web("#58a6ff"), Color.web("#ff7b72"), Color.web("#d9a23b"), Color.web("#161b22e6"), MeshInk.DARK,
            GroupPalette.ON_DARK,
        )
    }
}
