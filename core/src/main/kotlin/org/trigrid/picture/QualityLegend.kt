package org.trigrid.picture

import org.trigrid.mesh.TriMesh
import org.trigrid.quality.QualityReport
import org.trigrid.quality.TriangleQuality
import java.util.Locale

/** The colours of the quality classes, with the share of elements in each. */
internal class QualityLegend(private val mesh: TriMesh) {
    fun draw(scene: Scene, left: Double, top: Double) {
        val counts = IntArray(Palette.qualityColours.size)
        for (t in 0 until mesh.elementCount) counts[Palette.qualityClass(TriangleQuality.of(mesh, t))]++
        val report = QualityReport.of(mesh, 0)
        val heads = listOf(Label(left, top + TITLE, Anchor.START, "Element quality"))
        scene.add(Labels(Palette.INK, TITLE, true, heads))
        val names = ArrayList<Label>()
        val shares = ArrayList<Label>()
        var y = top + 2.1 * TITLE
        for (c in counts.indices.reversed()) {
            scene.add(Boxes(Palette.qualityColours[c], doubleArrayOf(left, y, SWATCH, ROW - 3)))
            val base = y + 0.5 * (ROW - 3) + 0.36 * TEXT
            names.add(Label(left + SWATCH + 10, base, Anchor.START, className(c)))
            shares.add(Label(left + WIDTH - 34, base, Anchor.END, share(counts[c])))
            y += ROW
        }
        scene.add(Labels(Palette.INK, TEXT, false, names))
        y += 0.5 * ROW
        val figures = listOf(
            "minimum" to number(report.minQuality, 3), "mean" to number(report.meanQuality, 3),
            "smallest angle" to number(report.minAngle, 1) + "\u00B0", "elements" to grouped(mesh.elementCount.toLong()),
        )
        val words = ArrayList<Label>()
        for ((word, figure) in figures) {
            y += ROW
            words.add(Label(left, y, Anchor.START, word))
            shares.add(Label(left + WIDTH - 34, y, Anchor.END, figure))
        }
        scene.add(Labels(Palette.MUTED, TEXT, false, words))
        scene.add(Labels(Palette.INK, TEXT, false, shares))
    }

    private fun className(c: Int): String = when (c) {
        0 -> "below " + number(Palette.qualityEnds[0], 2)
        Palette.qualityEnds.size -> number(Palette.qualityEnds[c - 1], 2) + " to 1"
        else -> number(Palette.qualityEnds[c - 1], 2) + " to " + number(Palette.qualityEnds[c], 2)
    }

    private fun share(count: Int): String {
        val percent = 100.0 * count / mesh.elementCount
        return if (count > 0 && percent < 0.05) "< 0.1 %" else number(percent, 1) + " %"
    }

    companion object {
        const val WIDTH = 236.0
        const val HEIGHT = 400.0
        private const val TITLE = 17.0
        private const val TEXT = 14.0
        private const val ROW = 24.0
        private const val SWATCH = 34.0

        /** With [places] decimals and a decimal point, whatever the platform's language. */
        fun number(value: Double, places: Int): String = String.format(Locale.ROOT, "%.${places}f", value)

        /** With blanks between groups of three digits. */
        fun grouped(value: Long): String =
            value.toString().reversed().chunked(3).joinToString(" ").reversed()
    }
}
