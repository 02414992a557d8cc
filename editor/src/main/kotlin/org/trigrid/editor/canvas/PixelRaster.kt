package org.trigrid.editor.canvas

/**
 * A picture of pixels 0xAARRGGBB, colours multiplied by their opacity, with lines and triangles. Coordinates in pixels,
 * x to the right and y down; what lies outside is cut off. Colours are opaque but for the strength that a line is given.
 */
internal class PixelRaster(val width: Int, val height: Int) {
    val pixels: IntArray = IntArray(width * height)

    fun clear(colour: Int) = pixels.fill(colour)

    /** All pixels of the box from (x0, y0) to (x1, y1) inclusive. */
    fun block(x0: Int, y0: Int, x1: Int, y1: Int, colour: Int) {
        val left = maxOf(x0, 0)
        val right = minOf(x1, width - 1)
        if (left > right) return
        for (y in maxOf(y0, 0)..minOf(y1, height - 1)) {
            for (at in y * width + left..y * width + right) pixels[at] = colour
        }
    }

    /** The pixels whose middles lie in a triangle, row by row. */
    fun triangle(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, colour: Int) {
        val top = Math.max(0.0, Math.ceil(Math.min(ay, Math.min(by, cy)) - HALF)).toInt()
        val bottom = Math.min(height - 1.0, Math.floor(Math.max(ay, Math.max(by, cy)) - HALF)).toInt()
        for (y in top..bottom) {
            val middle = y + HALF
            var from = Double.POSITIVE_INFINITY
            var to = Double.NEGATIVE_INFINITY
            if ((ay <= middle) != (by <= middle)) {
                val x = ax + (middle - ay) / (by - ay) * (bx - ax)
                from = Math.min(from, x)
                to = Math.max(to, x)
            }
            if ((by <= middle) != (cy <= middle)) {
                val x = bx + (middle - by) / (cy - by) * (cx - bx)
                from = Math.min(from, x)
                to = Math.max(to, x)
            }
            if ((cy <= middle) != (ay <= middle)) {
                val x = cx + (middle - cy) / (ay - cy) * (ax - cx)
                from = Math.min(from, x)
                to = Math.max(to, x)
            }
            val left = Math.max(0.0, Math.ceil(from - HALF)).toInt()
            val right = Math.min(width - 1.0, Math.ceil(to - HALF) - 1).toInt()
            if (left <= right) pixels.fill(colour, y * width + left, y * width + right + 1)
        }
    }

    /**
     * A smooth line of one pixel: each column, or row of a steep line, shares the colour between two pixels.
     *
     * @param strength 0..255, of the colour over what is there.
     */
    fun line(x0: Double, y0: Double, x1: Double, y1: Double, colour: Int, strength: Int) {
        if (Math.abs(x1 - x0) >= Math.abs(y1 - y0)) {
            if (x0 <= x1) flat(x0, y0, x1, y1, colour, strength) else flat(x1, y1, x0, y0, colour, strength)
        } else {
            if (y0 <= y1) steep(x0, y0, x1, y1, colour, strength) else steep(x1, y1, x0, y0, colour, strength)
        }
    }

    private fun flat(x0: Double, y0: Double, x1: Double, y1: Double, colour: Int, strength: Int) {
        val slope = if (x1 == x0) 0.0 else (y1 - y0) / (x1 - x0)
        val from = Math.max(0.0, Math.floor(x0)).toInt()
        val to = Math.min(width - 1.0, Math.floor(x1)).toInt()
        var y = y0 + slope * (from + HALF - x0) - HALF
        for (x in from..to) {
            val row = Math.floor(y)
            val share = ((y - row) * strength).toInt()
            val r = row.toInt()
            if (r in 0 until height) blend(r * width + x, colour, strength - share)
            if (r + 1 in 0 until height) blend((r + 1) * width + x, colour, share)
            y += slope
        }
    }

    private fun steep(x0: Double, y0: Double, x1: Double, y1: Double, colour: Int, strength: Int) {
        val slope = (x1 - x0) / (y1 - y0)
        val from = Math.max(0.0, Math.floor(y0)).toInt()
        val to = Math.min(height - 1.0, Math.floor(y1)).toInt()
        var x = x0 + slope * (from + HALF - y0) - HALF
        for (y in from..to) {
            val column = Math.floor(x)
            val share = ((x - column) * strength).toInt()
            val c = column.toInt()
            if (c in 0 until width) blend(y * width + c, colour, strength - share)
            if (c + 1 in 0 until width) blend(y * width + c + 1, colour, share)
            x += slope
        }
    }

    private fun blend(at: Int, colour: Int, strength: Int) {
        val under = pixels[at]
        val rest = FULL - strength
        val redBlue = ((colour and RED_BLUE) * strength + (under and RED_BLUE) * rest) ushr 8 and RED_BLUE
        val green = ((colour and GREEN) * strength + (under and GREEN) * rest) ushr 8 and GREEN
        val alpha = (OPAQUE * strength + (under ushr 24) * rest) ushr 8
        pixels[at] = (alpha shl 24) or redBlue or green
    }

    private companion object {
        const val HALF = 0.5
        const val FULL = 256
        const val OPAQUE = 255
        const val RED_BLUE = 0xFF00FF
        const val GREEN = 0x00FF00
    }
}
