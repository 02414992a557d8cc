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
        val width = layout.textWidth(text)
        val high = LabelLayout.DIGIT_HEIGHT * size
        val away = 0.75 * radius + 0.12 * size
        // Above right, above left, below right, below left.
        for (corner in 0..3) {
            val left = if (corner % 2 == 0) x + away else x - away - width
            val bottom = if (corner < 2) y - away else y + away + high
            if (layout.take(left, bottom - high, left + width, bottom)) return Label(left, bottom, Anchor.START, text)
        }
        return null
    }
}
