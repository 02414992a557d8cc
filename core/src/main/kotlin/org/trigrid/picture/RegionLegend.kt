package org.trigrid.picture

import org.trigrid.domain.Region

/** The colours of regions, with their names. */
internal class RegionLegend(private val regions: List<Region>, private val options: PictureOptions) {
    private val rows = minOf(regions.size, MAX_ROWS)

    val width: Double get() = SWATCH + 10 + RIGHT + (0 until rows).maxOf { LabelLayout.widthOf(text(it), TEXT) }
    val height: Double get() = rows * ROW

    fun colourOf(region: Int): Int = when {
        regions[region].name in options.groupColours -> options.groupColours.getValue(regions[region].name)
        region == 0 -> Palette.MATERIAL
        else -> Palette.regions[(region - 1) % Palette.regions.size]
    }

    fun draw(scene: Scene, left: Double, top: Double) {
        val labels = ArrayList<Label>()
        for (row in 0 until rows) {
            val y = top + row * ROW
            if (!isRest(row)) {
                scene.add(Boxes(Palette.FRAME, doubleArrayOf(left - 1, y - 1, SWATCH + 2, ROW - 1)))
                scene.add(Boxes(colourOf(row), doubleArrayOf(left, y, SWATCH, ROW - 3)))
            }
            labels.add(Label(left + SWATCH + 10, y + 0.5 * (ROW - 3) + 0.36 * TEXT, Anchor.START, text(row)))
        }
        scene.add(Labels(Palette.INK, TEXT, false, labels))
    }

    private fun isRest(row: Int) = row == MAX_ROWS - 1 && regions.size > MAX_ROWS

    private fun text(row: Int): String {
        val name = regions[row].name
        return if (isRest(row)) "and ${regions.size - MAX_ROWS + 1} more" else if (name.length <= 28) name else name.take(27) + "\u2026"
    }

    private companion object {
        const val TEXT = 14.0
        const val ROW = 24.0
        const val SWATCH = 34.0
        const val RIGHT = 30.0
        const val MAX_ROWS = 24
    }
}
