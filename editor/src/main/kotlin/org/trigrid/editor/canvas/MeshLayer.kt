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
    )

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

    /** Milliseconds that the last picture took. */
    var lastMillis: Double = 0.0
        private set

    /** The element under a place of the domain, or -1. */
    fun elementAt(view: MeshView, x: Double, y: Double): Int = raster?.takeIf { it.view === view }?.elementAt(x, y) ?: -1

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
        if (isPainting || request == null) return
        waiting = null
        isPainting = true
        painter.execute {
            val begin = System.nanoTime()
            val pixels = paint(request)
            val millis = (System.nanoTime() - begin) / 1e6
            Platform.runLater { finished(request, pixels, millis) }
        }
    }

    private fun paint(request: Request): PixelRaster {
        val ready = raster?.takeIf { it.view === request.view } ?: MeshRaster(request.view).also { raster = it }
        val pixels = PixelRaster(request.width, request.height)
        val t = request.transform
        ready.draw(pixels, ViewTransform(t.scale * request.density, t.left, t.top), request.colouring, request.ink)
        return pixels
    }

    /** Shows what is shown once more, at once and with [density] pixels to one of the window's, to be taken a picture of. */
    fun sharpen(density: Double) {
        val last = shown ?: return
        val width = Math.ceil(last.width / last.density * density).toInt()
        val height = Math.ceil(last.height / last.density * density).toInt()
        val request = Request(last.view, current, width, height, density, last.colouring, last.ink)
        put(request, paint(request))
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
}
