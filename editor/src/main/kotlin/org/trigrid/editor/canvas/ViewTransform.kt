package org.trigrid.editor.canvas

import kotlin.math.min

/**
 * Where a place of the domain lies on the screen: y upwards in the domain, downwards on the screen. Immutable.
 *
 * @param scale pixels per length of the domain, > 0.
 * @param left the domain's x at the screen's left edge.
 * @param top the domain's y at the screen's upper edge.
 */
internal class ViewTransform(val scale: Double, val left: Double, val top: Double) {
    /** Length of a pixel in the domain's unit. */
    val pixel: Double get() = 1 / scale

    fun screenX(x: Double): Double = (x - left) * scale

    fun screenY(y: Double): Double = (top - y) * scale

    fun domainX(screenX: Double): Double = left + screenX / scale

    fun domainY(screenY: Double): Double = top - screenY / scale

    /** Larger by [factor], the place at (screenX, screenY) staying where it is. */
    fun zoomed(factor: Double, screenX: Double, screenY: Double): ViewTransform {
        val next = (scale * factor).coerceIn(SMALLEST, LARGEST)
        return ViewTransform(next, domainX(screenX) - screenX / next, domainY(screenY) + screenY / next)
    }

    /** Shifted by pixels, as the mouse drags the sheet. */
    fun panned(dx: Double, dy: Double): ViewTransform = ViewTransform(scale, left - dx / scale, top + dy / scale)

    companion object {
        private const val SMALLEST = 1e-12
        private const val LARGEST = 1e15

        /**
         * Shows the box as large as a screen of [width] by [height] pixels allows, in its middle, with a [margin]
         * in pixels on all sides. A box without extent is shown at one pixel per length.
         */
        fun fit(box: Box, width: Double, height: Double, margin: Double): ViewTransform {
            val roomX = (width - 2 * margin).coerceAtLeast(1.0)
            val roomY = (height - 2 * margin).coerceAtLeast(1.0)
            val scale = min(roomX / box.width, roomY / box.height)
            val usable = if (scale > 0 && scale < Double.POSITIVE_INFINITY) scale else 1.0
            return ViewTransform(usable, box.middleX - width / 2 / usable, box.middleY + height / 2 / usable)
        }
    }
}
