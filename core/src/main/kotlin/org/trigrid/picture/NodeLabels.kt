package org.trigrid.picture

/** Places the numbers of nodes beside them, and leaves out those that have no room. */
internal object NodeLabels {
    /** @param donuts x, y, radius of the nodes, in the order of their numbers. */
    fun place(layout: LabelLayout, size: Double, donuts: DoubleArray, firstNumber: Int): List<Label> {
        for (i in donuts.indices step 3) {
            val r = donuts[i + 2]
            layout.block(donuts[i] - r, donuts[i + 1] - r, donuts[i] + r, donuts[i + 1] + r)
        }
        val labels = ArrayList<Label>()
        for (i in donuts.indices step 3) {
            val text = (i / 3 + firstNumber).toString()
            place(layout, size, donuts[i], donuts[i + 1], donuts[i + 2], text)?.let { labels.add(it) }
        }
        return labels
    }

    private fun place(layout: LabelLayout, size: Double, x: Double, y: Double, radius: Double, text: String): Label? {
        val width = LabelLayout.widthOf(text, size)
        val high = LabelLayout.DIGIT_HEIGHT * size
        for (i in TO_SIDE.indices) {
            // On the slant a label may come a little nearer than straight beside the node.
            val away = (if (TO_SIDE[i] * UPWARDS[i] != 0) 0.75 else 1.2) * radius + 0.14 * size
            val middle = x + TO_SIDE[i] * (away + 0.5 * width)
            val bottom = y + 0.5 * high - UPWARDS[i] * (away + 0.5 * high)
            if (layout.take(middle - 0.5 * width, bottom - high, middle + 0.5 * width, bottom)) {
                return anchored(x, middle, width, bottom, TO_SIDE[i], text)
            }
        }
        return null
    }

    /** Texts hang by the end that is next to their node, so that a narrower font leaves no gap there. */
    private fun anchored(x: Double, middle: Double, width: Double, bottom: Double, side: Int, text: String): Label = when {
        side > 0 -> Label(middle - 0.5 * width, bottom, Anchor.START, text)
        side < 0 -> Label(middle + 0.5 * width, bottom, Anchor.END, text)
        else -> Label(x, bottom, Anchor.MIDDLE, text)
    }

    /** Where labels are tried: above right, above left, below right, below left, then straight beside the node. */
    private val TO_SIDE = intArrayOf(1, -1, 1, -1, 1, -1, 0, 0)
    private val UPWARDS = intArrayOf(1, 1, -1, -1, 0, 0, 1, -1)
}
