package org.trigrid.picture

/**
 * Where the plane lies on the sheet: y up there, y down here.
 *
 * @param xy x0, y0, …, all that is to be seen; not finite numbers are ignored.
 * @param size longer side of the drawing.
 */
internal class View(xy: DoubleArray, size: Double, private val margin: Double) {
    private val minX: Double
    private val maxY: Double
    val scale: Double

    /** Size of the drawing without margins. */
    val width: Double
    val height: Double

    init {
        var x0 = Double.POSITIVE_INFINITY
        var x1 = Double.NEGATIVE_INFINITY
        var y0 = Double.POSITIVE_INFINITY
        var y1 = Double.NEGATIVE_INFINITY
        for (i in xy.indices step 2) {
            if (!xy[i].isFinite() || !xy[i + 1].isFinite()) continue
            x0 = minOf(x0, xy[i])
            x1 = maxOf(x1, xy[i])
            y0 = minOf(y0, xy[i + 1])
            y1 = maxOf(y1, xy[i + 1])
        }
        val spanX = if (x1 >= x0) x1 - x0 else 0.0
        val spanY = if (y1 >= y0) y1 - y0 else 0.0
        val span = maxOf(spanX, spanY)
        scale = if (span > 0) size / span else 1.0
        minX = if (x1 >= x0) x0 else 0.0
        maxY = if (y1 >= y0) y1 else 0.0
        // A line along an axis still gets a strip of paper.
        width = maxOf(spanX * scale, MIN_SIDE * size)
        height = maxOf(spanY * scale, MIN_SIDE * size)
    }

    fun x(x: Double): Double = margin + (x - minX) * scale

    fun y(y: Double): Double = margin + (maxY - y) * scale

    private companion object {
        const val MIN_SIDE = 0.1
    }
}
