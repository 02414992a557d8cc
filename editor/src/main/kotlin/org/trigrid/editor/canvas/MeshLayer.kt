package org.trigrid.editor.canvas

import javafx.application.Platform
import javafx.scene.image.ImageView
import javafx.scene.image.PixelBuffer
import javafx.scene.image.PixelFormat
import javafx.scene.image.WritableImage
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import java.nio.IntBuffer
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors

/**
 * Shows the mesh: drawn by a thread of its own into pixels, and moved with the view until the next picture is there.
 */
internal class MeshLayer {
    val node = ImageView().apply { isMouseTransparent = true; isSmooth = false }

    private class Request(
        val view: MeshView,
        val transform: ViewTransform,
        val width: Int,
        val height: Int,
        val density: Double,
        val colouring: Colouring,
        val ink: MeshInk,
    ) {
        /** How many pixels to the right and down [other]'s picture has to be moved to fit into this one; null if it does not fit. */
        fun shiftOf(other: Request): IntArray? {
            val isAlike = other.view === view && other.transform.scale == transform.scale && other.width == width &&
                other.height == height && other.density == density && other.colouring == colouring && other.ink === ink
            if (!isAlike) return null
            val scale = transform.scale * density
            val dx = (other.transform.left - transform.left) * scale
            val dy = (transform.top - other.transform.top) * scale
            val isWhole = Math.abs(dx - Math.rint(dx)) < WHOLE && Math.abs(dy - Math.rint(dy)) < WHOLE
            return if (isWhole && Math.abs(dx) < width && Math.abs(dy) < height) intArrayOf(Math.rint(dx).toInt(), Math.rint(dy).toInt()) else null
        }
    }

    private val painter: ExecutorService = Executors.newSingleThreadExecutor { work ->
        Thread(work, "mesh-painter").apply { isDaemon = true }
    }
    private var isPainting = false
    private var wanted: MeshView? = null
    private var waiting: Request? = null
    private var shown: Request? = null
    private var current: ViewTransform = ViewTransform(1.0, 0.0, 0.0)

    @Volatile
    private var raster: MeshRaster? = null

    /** What the painter's thread has painted last; of no other thread. */
    private var painted: Pair<Request, PixelRaster>? = null

    /** Milliseconds that the last picture took. */
    var lastMillis: Double = 0.0
        private set

    /** The element under a place of the domain, or -1. */
    fun elementAt(view: MeshView, x: Double, y: Double): Int = index(view)?.elementAt(x, y) ?: -1

    /** The index of [view]'s elements, or null while it is not ready. */
    fun index(view: MeshView): MeshRaster? = raster?.takeIf { it.view === view }

    /**
     * Shows [view], or nothing where it is null.
     *
     * @param density pixels of the screen to one of the window's.
     */
    fun show(
        view: MeshView?,
        transform: ViewTransform,
        width: Double,
        height: Double,
        density: Double,
        colouring: Colouring,
        ink: MeshInk,
    ) {
        current = transform
        wanted = view
        if (view == null || width < 1 || height < 1) {
            waiting = null
            shown = null
            node.image = null
            return
        }
        follow()
        val pixelWidth = Math.ceil(width * density).toInt()
        val pixelHeight = Math.ceil(height * density).toInt()
        waiting = Request(view, transform, pixelWidth, pixelHeight, density, colouring, ink)
        next()
    }

    private fun next() {
        val request = waiting
        if (isPainting || request == null || painter.isShutdown) return
        waiting = null
        isPainting = true
        painter.execute {
            val begin = System.nanoTime()
            val pixels = paint(request, painted)
            painted = request to pixels
            val millis = (System.nanoTime() - begin) / 1e6
            Platform.runLater { finished(request, pixels, millis) }
        }
    }

    /** The picture that is asked for; where the sheet was only moved since [before], that one moved and its rims drawn. */
    private fun paint(request: Request, before: Pair<Request, PixelRaster>?): PixelRaster {
        val ready = index(request.view) ?: MeshRaster(request.view).also { raster = it }
        val pixels = PixelRaster(request.width, request.height)
        val t = request.transform
        val draw = { ready.draw(pixels, ViewTransform(t.scale * request.density, t.left, t.top), request.colouring, request.ink) }
        val shift = before?.let { request.shiftOf(it.first) }
        if (shift == null) {
            draw()
            return pixels
        }
        val (dx, dy) = shift
        pixels.copyMoved(before.second, dx, dy)
        if (dx > 0) pixels.clip(0, 0, dx, request.height) else pixels.clip(request.width + dx, 0, request.width, request.height)
        if (dx != 0) draw()
        val left = Math.max(0, dx)
        val right = Math.min(request.width, request.width + dx)
        if (dy > 0) pixels.clip(left, 0, right, dy) else pixels.clip(left, request.height + dy, right, request.height)
        if (dy != 0) draw()
        return pixels
    }

    /** Shows what is shown once more, at once and with [density] pixels to one of the window's, to be taken a picture of. */
    fun sharpen(density: Double) {
        val last = shown ?: return
        val width = Math.ceil(last.width / last.density * density).toInt()
        val height = Math.ceil(last.height / last.density * density).toInt()
        val request = Request(last.view, current, width, height, density, last.colouring, last.ink)
        put(request, paint(request, null))
    }

    private fun put(request: Request, pixels: PixelRaster) {
        val buffer = PixelBuffer(request.width, request.height, IntBuffer.wrap(pixels.pixels), PixelFormat.getIntArgbPreInstance())
        node.image = WritableImage(buffer)
        shown = request
        follow()
    }

    private fun finished(request: Request, pixels: PixelRaster, millis: Double) {
        isPainting = false
        lastMillis = millis
        if (request.view === wanted) put(request, pixels)
        next()
    }

    /** Puts the picture where its places lie in the view of now. */
    private fun follow() {
        val request = shown ?: return
        val scale = current.scale / request.transform.scale
        node.fitWidth = request.width / request.density * scale
        node.fitHeight = request.height / request.density * scale
        node.x = current.screenX(request.transform.left)
        node.y = current.screenY(request.transform.top)
    }

    fun close() {
        painter.shutdownNow()
    }

    private companion object {
        /** What a shift may be off a whole number of pixels. */
        const val WHOLE = 1e-4
    }
}
