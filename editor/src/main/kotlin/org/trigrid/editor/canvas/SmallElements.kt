package org.trigrid.editor.canvas

/**
 * Elements as their boxes' middles and reaches, read one after the other: those finer than the screen's pixels are drawn
 * as the pixels they touch, without a look at their corners.
 *
 * Single precision is enough: an element is drawn so only where its whole box is about a pixel.
 */
internal class SmallElements(xy: DoubleArray, nodes: IntArray) {
    private val originX: Double = if (xy.isEmpty()) 0.0 else xy[0]
    private val originY: Double = if (xy.isEmpty()) 0.0 else xy[1]
    private val middleX = FloatArray(nodes.size / 3)
    private val middleY = FloatArray(nodes.size / 3)

    /** Half the longer side of the box. */
    private val reach = FloatArray(nodes.size / 3)

    init {
        for (i in reach.indices) {
            val a = 2 * nodes[3 * i]
            val b = 2 * nodes[3 * i + 1]
            val c = 2 * nodes[3 * i + 2]
            val left = Math.min(xy[a], Math.min(xy[b], xy[c]))
            val right = Math.max(xy[a], Math.max(xy[b], xy[c]))
            val bottom = Math.min(xy[a + 1], Math.min(xy[b + 1], xy[c + 1]))
            val top = Math.max(xy[a + 1], Math.max(xy[b + 1], xy[c + 1]))
            middleX[i] = ((left + right) / 2 - originX).toFloat()
            middleY[i] = ((bottom + top) / 2 - originY).toFloat()
            reach[i] = (Math.max(right - left, top - bottom) / 2).toFloat()
        }
    }

    /** Draws element [i] if it is small enough. @return whether it was. */
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
