package org.trigrid.cli.bench

import java.util.Locale

/** Rows of cells below a heading, as Markdown. The first column is text, the others are numbers. */
internal class MarkdownTable(private vararg val heading: String) {
    private val rows = ArrayList<List<String>>()

    fun add(cells: List<String>) {
        require(cells.size == heading.size) { "${cells.size} cells under ${heading.size} headings" }
        rows.add(cells)
    }

    override fun toString(): String = buildString {
        line(heading.toList())
        line(heading.indices.map { if (it == 0) "---" else "---:" })
        for (row in rows) line(row)
    }

    private fun StringBuilder.line(cells: List<String>) = append(cells.joinToString(" | ", "| ", " |\n"))

    companion object {
        /** A number of so many [decimals], or a dash for NaN and infinity. */
        fun number(value: Double, decimals: Int): String =
            if (!value.isFinite()) "–" else "%,.${decimals}f".format(Locale.ROOT, value)

        /** A number of three significant digits. */
        fun rounded(value: Double): String = when {
            !value.isFinite() -> "–"
            value >= 100 -> number(value, 0)
            value >= 10 -> number(value, 1)
            value >= 1 -> number(value, 2)
            else -> "%.3g".format(Locale.ROOT, value)
        }
    }
}
