package org.trigrid.editor.canvas

import javafx.scene.canvas.GraphicsContext
import javafx.scene.image.PixelFormat
import javafx.scene.image.WritableImage
import javafx.scene.paint.Color
import org.trigrid.editor.meshing.FrontPlayback
import org.trigrid.front.FrontTrace

/** Draws the film of the front: the elements made so far, the one made last, the front, and the side whose turn it is. */
internal class FrontPainter {
    private var film: FrontPlayback? = null
    private var view: ViewTransform? = null
    private var ink: MeshInk? = null
    private var drawn = 0
    private var pixels = PixelRaster(0, 0)
    private var image = WritableImage(1, 1)

    fun draw(g: GraphicsContext, playback: FrontPlayback, to: ViewTransform, width: Double, height: Double, density: Double, colours: CanvasColours) {
        bring(playback, to, Math.ceil(width * density).toInt(), Math.ceil(height * density).toInt(), density, colours.mesh)
        g.drawImage(image, 0.0, 0.0, pixels.width / density, pixels.height / density)
        val trace = playback.trace
        if (playback.lastElement >= 0) element(g, trace, playback.lastElement, to, colours.accent)
        val front = playback.front
        g.stroke = colours.accent
        g.lineWidth = if (front.size / 2 > MANY) 1.2 else 2.4
        for (i in front.indices step 2) side(g, trace, front[i], front[i + 1], to, width, height)
        val current = playback.currentSide ?: return
        g.stroke = colours.fault
        g.lineWidth = 5.0
        side(g, trace, current[0], current[1], to, width, height)
    }

    /** Brings the picture of the elements up to date; where only some were added only those are drawn. */
    private fun bring(playback: FrontPlayback, to: ViewTransform, width: Int, height: Int, density: Double, meshInk: MeshInk) {
        val goesOn = playback === film && to === view && meshInk === ink && width == pixels.width && height == pixels.height &&
            playback.position >= drawn
        if (goesOn && playback.position == drawn) return
        if (!goesOn) {
            if (width != pixels.width || height != pixels.height) {
                pixels = PixelRaster(width, height)
                image = WritableImage(width, height)
            }
            pixels.clear(0)
            drawn = 0
        }
        val scaled = ViewTransform(to.scale * density, to.left, to.top)
        for (element in drawn until playback.position) element(playback.trace, element, scaled, meshInk)
        image.pixelWriter.setPixels(0, 0, width, height, PixelFormat.getIntArgbPreInstance(), pixels.pixels, 0, width)
        film = playback
        view = to
        ink = meshInk
        drawn = playback.position
    }

    private fun element(trace: FrontTrace, element: Int, t: ViewTransform, ink: MeshInk) {
        val xs = DoubleArray(3) { t.screenX(trace.x(trace.nodeOf(element, it))) }
        val ys = DoubleArray(3) { t.screenY(trace.y(trace.nodeOf(element, it))) }
        if (xs.max() < 0 || ys.max() < 0 || xs.min() > pixels.width || ys.min() > pixels.height) return
        pixels.triangle(xs[0], ys[0], xs[1], ys[1], xs[2], ys[2], ink.fill)
        for (k in 0..2) pixels.line(xs[k], ys[k], xs[(k + 1) % 3], ys[(k + 1) % 3], ink.line, LINE_STRENGTH)
    }

    private fun element(g: GraphicsContext, trace: FrontTrace, element: Int, to: ViewTransform, colour: Color) {
        g.fill = colour.deriveColor(0.0, 1.0, 1.0, LAST_STRENGTH)
        val xs = DoubleArray(3) { to.screenX(trace.x(trace.nodeOf(element, it))) }
        val ys = DoubleArray(3) { to.screenY(trace.y(trace.nodeOf(element, it))) }
        g.fillPolygon(xs, ys, 3)
    }

    private fun side(g: GraphicsContext, trace: FrontTrace, a: Int, b: Int, to: ViewTransform, width: Double, height: Double) {
        val ax = to.screenX(trace.x(a))
        val ay = to.screenY(trace.y(a))
        val bx = to.screenX(trace.x(b))
        val by = to.screenY(trace.y(b))
        if (Math.max(ax, bx) < 0 || Math.max(ay, by) < 0 || Math.min(ax, bx) > width || Math.min(ay, by) > height) return
        g.strokeLine(ax, ay, bx, by)
    }

    private companion object {
        const val LINE_STRENGTH = 200
        const val LAST_STRENGTH = 0.45

        /** Sides above which the front is drawn thinly. */
        const val MANY = 3000
    }
}
