package org.trigrid.editor.canvas

/**
 * A picture of pixels 0xAARRGGBB, colours multiplied by their opacity, with lines and triangles. Coordinates in pixels,
 * x to the right and y down; what lies outside the clip is cut off. Colours are opaque but for the strength that a line is
 * given.
 */
internal class PixelRaster(val width: Int, val height: Int) {
    val pixels: IntArray = IntArray(width * height)

    /** The clip: pixels from [left] until [right] and from [top] until [bottom]; at first all. */
    var left: Int = 0
        private set
    var top: Int = 0
        private set
    var right: Int = width
        private set
    var bottom: Int = height
        private set

    fun clip(left: Int, top: Int, right: Int, bottom: Int) {
        this.left = left.coerceIn(0, width)
        this.top = top.coerceIn(0, height)
        this.right = right.coerceIn(this.left, width)
        this.bottom = bottom.coerceIn(this.top, height)
    }

    /** Takes over the pixels of [other], of the same size, each moved by ([dx], [dy]). What comes from outside stays. */
    fun copyMoved(other: PixelRaster, dx: Int, dy: Int) {
        val length = width - Math.abs(dx)
        if (length <= 0) return
        for (y in Math.max(0, dy) until Math.min(height, height + dy)) {
            other.pixels.copyInto(pixels, y * width + Math.max(0, dx), (y - dy) * width + Math.max(0, -dx), (y - dy) * width + Math.max(0, -dx) + length)
        }
    }

    fun clear(colour: Int) = pixels.fill(colour)

    /** All pixels of the box from (x0, y0) to (x1, y1) inclusive. */
    fun block(x0: Int, y0: Int, x1: Int, y1: Int, colour: Int) {
        val from = Math.max(x0, left)
        val to = Math.min(x1, right - 1)
        val last = Math.min(y1, bottom - 1)
        var y = Math.max(y0, top)
        while (y <= last) {
            var at = y * width + from
            val end = y * width + to
            while (at <= end) pixels[at++] = colour
            y++
        }
    }

    /** The pixels whose middles lie in a triangle, row by row. An edge that two triangles share is the same line for both. */
    fun triangle(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, colour: Int) {
        when {
            ay <= by && by <= cy -> rows(ax, ay, bx, by, cx, cy, colour)
            ay <= cy && cy <= by -> rows(ax, ay, cx, cy, bx, by, colour)
            by <= ay && ay <= cy -> rows(bx, by, ax, ay, cx, cy, colour)
            by <= cy && cy <= ay -> rows(bx, by, cx, cy, ax, ay, colour)
            cy <= ay && ay <= by -> rows(cx, cy, ax, ay, bx, by, colour)
            else -> rows(cx, cy, bx, by, ax, ay, colour)
        }
    }

    /** A triangle with its corners from the uppermost to the lowest. */
    private fun rows(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double, colour: Int) {
        val begin = firstMiddle(ay, top, bottom)
        val end = firstMiddle(cy, top, bottom)
        if (begin >= end) return
        val long = (cx - ax) / (cy - ay)
        val upper = (bx - ax) / (by - ay)
        val lower = (cx - bx) / (cy - by)
        for (y in begin until end) {
            val middle = y + HALF
            val p = ax + (middle - ay) * long
            val q = if (middle < by) ax + (middle - ay) * upper else bx + (middle - by) * lower
            val from = y * width + firstMiddle(Math.min(p, q), left, right)
            val to = y * width + firstMiddle(Math.max(p, q), left, right)
            for (at in from until to) pixels[at] = colour
        }
    }

    /** The first pixel of a row, from [low] until [high], whose middle does not lie before [place]. */
    private fun firstMiddle(place: Double, low: Int, high: Int): Int {
        val shifted = place - HALF
        if (!(shifted > low)) return low
        if (shifted >= high) return high
        val whole = shifted.toInt()
        return if (shifted > whole) whole + 1 else whole
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
        val from = Math.max(left.toDouble(), Math.floor(x0)).toInt()
        val to = Math.min(right - 1.0, Math.floor(x1)).toInt()
        var y = y0 + slope * (from + HALF - x0) - HALF
        for (x in from..to) {
            val row = Math.floor(y)
            val share = ((y - row) * strength).toInt()
            val r = row.toInt()
            if (r in top until bottom) blend(r * width + x, colour, strength - share)
            if (r + 1 in top until bottom) blend((r + 1) * width + x, colour, share)
            y += slope
        }
    }

    private fun steep(x0: Double, y0: Double, x1: Double, y1: Double, colour: Int, strength: Int) {
        val slope = (x1 - x0) / (y1 - y0)
        val from = Math.max(top.toDouble(), Math.floor(y0)).toInt()
        val to = Math.min(bottom - 1.0, Math.floor(y1)).toInt()
        var x = x0 + slope * (from + HALF - y0) - HALF
        for (y in from..to) {
            val column = Math.floor(x)
            val share = ((x - column) * strength).toInt()
            val c = column.toInt()
            if (c in left until right) blend(y * width + c, colour, strength - share)
            if (c + 1 in left until right) blend(y * width + c + 1, colour, share)
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
