package org.trigrid.editor.canvas

/** An upright rectangle. Immutable. */
internal class Box(val minX: Double, val minY: Double, val maxX: Double, val maxY: Double) {
    val width: Double get() = maxX - minX
    val height: Double get() = maxY - minY
    val middleX: Double get() = minX + width / 2
    val middleY: Double get() = minY + height / 2

    companion object {
        /** The box with the corners x0, y0, x1, y1; null where there is none. */
        fun of(corners: DoubleArray?): Box? {
            if (corners == null || corners.any { !it.isFinite() }) return null
            return Box(corners[0], corners[1], corners[2], corners[3])
        }
    }
}
