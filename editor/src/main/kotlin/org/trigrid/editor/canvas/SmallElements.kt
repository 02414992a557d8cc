package org.trigrid.editor.canvas

/**
 * Elements, or groups of [size] elements that follow each other, as their boxes' middles and reaches, read one after the
 * other: those finer than the screen's pixels are drawn as the pixels they touch, without a look at their corners.
 *
 * Single precision is enough: an element is drawn so only where its whole box is about a pixel.
 */
internal class SmallElements(xy: DoubleArray, nodes: IntArray, val size: Int) {
    private val originX: Double = if (xy.isEmpty()) 0.0 else xy[0]
    private val originY: Double = if (xy.isEmpty()) 0.0 else xy[1]
    private val middleX = FloatArray((nodes.size / 3 + size - 1) / size)
    private val middleY = FloatArray(middleX.size)

    /** Half the longer side of the box. */
    private val reach = FloatArray(middleX.size)

    private val meanReach: Float

    init {
        for (i in reach.indices) {
            var left = Double.POSITIVE_INFINITY
            var right = Double.NEGATIVE_INFINITY
            var bottom = Double.POSITIVE_INFINITY
            var top = Double.NEGATIVE_INFINITY
            for (at in 3 * i * size until Math.min(nodes.size, 3 * (i + 1) * size)) {
                val x = xy[2 * nodes[at]]
                val y = xy[2 * nodes[at] + 1]
                left = Math.min(left, x)
                right = Math.max(right, x)
                bottom = Math.min(bottom, y)
                top = Math.max(top, y)
            }
            middleX[i] = ((left + right) / 2 - originX).toFloat()
            middleY[i] = ((bottom + top) / 2 - originY).toFloat()
            reach[i] = (Math.max(right - left, top - bottom) / 2).toFloat()
        }
        meanReach = reach.average().toFloat()
    }

    fun areMostlySmall(t: ViewTransform): Boolean = meanReach * t.scale < SMALL

    /** Draws element or group [i] if it is small enough. @return whether it was. */
    fun draw(raster: PixelRaster, t: ViewTransform, i: Int, colour: Int): Boolean {
        val r = reach[i] * t.scale
        if (r > SMALL) return false
        val x = t.screenX(originX) + middleX[i] * t.scale
        val y = t.screenY(originY) - middleY[i] * t.scale
        if (x < -1 || y < -1) return true
        raster.block((x - r).toInt(), (y - r).toInt(), (x + r).toInt(), (y + r).toInt(), colour)
        return true
    }

    private companion object {
        /** In pixels. */
        const val SMALL = 0.75
    }
}
