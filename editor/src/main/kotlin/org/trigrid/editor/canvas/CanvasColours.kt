package org.trigrid.editor.canvas

import javafx.scene.paint.Color

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
    private val groups: List<Color>,
) {
    /** Colour of the boundary group with the given place in the list of groups. */
    fun group(index: Int): Color = groups[Math.floorMod(index, groups.size)]

    companion object {
        /** Okabe and Ito's colours (2002), which colour-blind people can tell apart; without yellow, which fails on white. */
        private val ON_LIGHT = listOf("#1b2a38", "#d55e00", "#0072b2", "#009e73", "#b3568f", "#b87d00", "#2b8fc4", "#8b5a2b")
        private val ON_DARK = listOf("#dbe4ec", "#ff8a3d", "#56b4e9", "#2fd0a0", "#e39ac6", "#f0c040", "#9ad1f5", "#c89a6a")

        val LIGHT = CanvasColours(
            Color.web("#ffffff"), Color.web("#eef1f4"), Color.web("#dde3e9"), Color.web("#c3ccd5"),
            Color.web("#8795a3"), Color.web("#0b5c99"), Color.web("#ffffff"), Color.web("#1b2a38"), Color.web("#66788a"),
            Color.web("#0969da"), Color.web("#cf222e"), Color.web("#9a6700"), Color.web("#ffffffe6"), MeshInk.LIGHT,
            ON_LIGHT.map { Color.web(it) },
        )
        val DARK = CanvasColours(
            Color.web("#0d1117"), Color.web("#171d25"), Color.web("#222a34"), Color.web("#3a4552"),
            Color.web("#7d8b99"), Color.web("#79c0ff"), Color.web("#0d1117"), Color.web("#e6edf3"), Color.web("#8b98a5"),
            Color.web("#58a6ff"), Color.web("#ff7b72"), Color.web("#d9a23b"), Color.web("#161b22e6"), MeshInk.DARK,
            ON_DARK.map { Color.web(it) },
        )
    }
}
