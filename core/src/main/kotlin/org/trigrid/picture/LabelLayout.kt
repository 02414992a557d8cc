package org.trigrid.picture

/** Keeps account of the room that labels take, so that none covers another. */
internal class LabelLayout(width: Double, height: Double, private val fontSize: Double) {
    private val cell = 2 * fontSize
    private val columns = (width / cell).toInt() + 2
    private val rows = (height / cell).toInt() + 2

    /** Boxes by the cells that they touch: left, top, right, bottom each. */
    private val cells = arrayOfNulls<ArrayList<DoubleArray>>(columns * rows)

    fun textWidth(text: String): Double = widthOf(text, fontSize)

    /** Takes the box if nothing is in it yet. */
    fun take(left: Double, top: Double, right: Double, bottom: Double): Boolean {
        val box = doubleArrayOf(left, top, right, bottom)
        if (anyCell(box) { list -> list != null && list.any { overlaps(it, box) } }) return false
        occupy(box)
        return true
    }

    /** Marks a box as full without asking. */
    fun block(left: Double, top: Double, right: Double, bottom: Double) = occupy(doubleArrayOf(left, top, right, bottom))

    private fun occupy(box: DoubleArray) {
        for (row in row(box[1])..row(box[3])) for (column in column(box[0])..column(box[2])) {
            val at = row * columns + column
            val list = cells[at] ?: ArrayList<DoubleArray>().also { cells[at] = it }
            list.add(box)
        }
    }

    private inline fun anyCell(box: DoubleArray, test: (ArrayList<DoubleArray>?) -> Boolean): Boolean {
        for (row in row(box[1])..row(box[3])) for (column in column(box[0])..column(box[2])) {
            if (test(cells[row * columns + column])) return true
        }
        return false
    }

    private fun overlaps(a: DoubleArray, b: DoubleArray): Boolean = a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]

    private fun column(x: Double): Int = (x / cell).toInt().coerceIn(0, columns - 1)

    private fun row(y: Double): Int = (y / cell).toInt().coerceIn(0, rows - 1)

    companion object {
        /** Height of digits, as a part of the font size. */
        const val DIGIT_HEIGHT = 0.73

        /** Width of a line of text in a common sans-serif font; digits are exact, other letters a mean. */
        fun widthOf(text: String, fontSize: Double): Double = 0.556 * fontSize * text.length
    }
}
