package org.trigrid.picture

/** Keeps account of the room that labels take, so that none covers another. */
internal class LabelLayout(private val width: Double, private val height: Double, private val fontSize: Double) {
    private val cell = 2 * fontSize
    private val columns = (width / cell).toInt() + 2
    private val rows = (height / cell).toInt() + 2

    /** Boxes by the cells that they touch: left, top, right, bottom each. */
    private val cells = arrayOfNulls<ArrayList<DoubleArray>>(columns * rows)

    /** Takes the box if it is on the sheet and nothing is in it yet. */
    fun take(left: Double, top: Double, right: Double, bottom: Double): Boolean {
        if (left < EDGE || top < EDGE || right > width - EDGE || bottom > height - EDGE) return false
        val box = doubleArrayOf(left, top, right, bottom)
        if (anyCell(box) { list -> list != null && list.any { overlaps(it, box) } }) return false
        occupy(box)
        return true
    }

    /** Marks a box as full without asking. */
    fun block(left: Double, top: Double, right: Double, bottom: Double) = occupy(doubleArrayOf(left, top, right, bottom))

    /** Marks what a line covers. */
    fun blockLine(x0: Double, y0: Double, x1: Double, y1: Double) {
        val steps = Math.ceil(Math.hypot(x1 - x0, y1 - y0) / LINE_STEP).toInt()
        if (steps > MOST_STEPS) return
        for (i in 0..steps) {
            val t = if (steps == 0) 0.0 else i / steps.toDouble()
            val x = x0 + t * (x1 - x0)
            val y = y0 + t * (y1 - y0)
            block(x - LINE_HALF, y - LINE_HALF, x + LINE_HALF, y + LINE_HALF)
        }
    }

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

        private const val EDGE = 8.0
        private const val LINE_STEP = 2.5
        private const val LINE_HALF = 0.8
        private const val MOST_STEPS = 10_000

        /** Width of a line of text in the widest of the common sans-serif fonts, bold or not. */
        fun widthOf(text: String, fontSize: Double): Double = 0.7 * fontSize * text.length
    }
}
