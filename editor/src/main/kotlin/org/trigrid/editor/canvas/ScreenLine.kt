package org.trigrid.editor.canvas

import javafx.scene.canvas.GraphicsContext

/** A line of many points on its way to the screen: what is off it, or finer than its pixels, is left out. */
internal class ScreenLine(private val view: ViewTransform, private val width: Double, private val height: Double) {
    private var xs = DoubleArray(64)
    private var ys = DoubleArray(64)
    private var size = 0

    fun add(x: Double, y: Double) {
        if (size == xs.size) {
            xs = xs.copyOf(2 * size)
            ys = ys.copyOf(2 * size)
        }
        xs[size] = view.screenX(x)
        ys[size++] = view.screenY(y)
    }

    fun stroke(g: GraphicsContext) {
        if (size < 2) return
        g.beginPath()
        var isDown = false
        var lastX = xs[0]
        var lastY = ys[0]
        for (i in 1 until size) {
            val isEnd = i == size - 1
            if (!isEnd && Math.abs(xs[i] - lastX) < FINE && Math.abs(ys[i] - lastY) < FINE) continue
            if (isSeen(lastX, lastY, xs[i], ys[i])) {
                val from = clipped(lastX, lastY, xs[i], ys[i])
                val to = clipped(xs[i], ys[i], lastX, lastY)
                if (!isDown || from[0] != lastX || from[1] != lastY) g.moveTo(from[0], from[1])
                g.lineTo(to[0], to[1])
                isDown = to[0] == xs[i] && to[1] == ys[i]
            } else {
                isDown = false
            }
            lastX = xs[i]
            lastY = ys[i]
        }
        g.stroke()
    }

    private fun isSeen(ax: Double, ay: Double, bx: Double, by: Double): Boolean =
        Math.max(ax, bx) >= -MARGIN && Math.min(ax, bx) <= width + MARGIN && Math.max(ay, by) >= -MARGIN && Math.min(ay, by) <= height + MARGIN

    /** The first point, drawn in along the line where it is so far off that the canvas would lose its precision. */
    private fun clipped(x: Double, y: Double, toX: Double, toY: Double): DoubleArray {
        var cx = x
        var cy = y
        if (Math.abs(cx) > FAR) {
            val edge = Math.copySign(FAR, cx)
            cy += (edge - cx) / (toX - cx) * (toY - cy)
            cx = edge
        }
        if (Math.abs(cy) > FAR) {
            val edge = Math.copySign(FAR, cy)
            cx += (edge - cy) / (toY - cy) * (toX - cx)
            cy = edge
        }
        return doubleArrayOf(cx, cy)
    }

    private companion object {
        const val FINE = 0.7
        const val MARGIN = 10.0
        const val FAR = 20_000.0
    }
}
