package org.trigrid.picture

import org.trigrid.io.AtomicFile
import java.awt.image.BufferedImage
import java.io.IOException
import java.nio.file.Path

/** A finished picture, to be written as often and in as many forms as wanted. Immutable. */
public class Picture internal constructor(private val scene: Scene) {
    /** Width in the picture's own units; an SVG file has this many pixels. */
    @get:JvmName("width")
    public val width: Double get() = scene.width

    /** Height in the picture's own units. */
    @get:JvmName("height")
    public val height: Double get() = scene.height

    /** Writes an SVG file; the file is written beside its place and moved over it. */
    @Throws(IOException::class)
    public fun writeSvg(path: Path): Unit = AtomicFile.write(path) { SvgBackend.write(scene, it) }

    /**
     * Writes a PNG file; the file is written beside its place and moved over it. On a machine without any font the
     * texts are missing.
     *
     * @param pixels the longer side of the picture, 16 to 30000.
     */
    @Throws(IOException::class)
    public fun writePng(path: Path, pixels: Int) {
        val image = toImage(pixels)
        AtomicFile.write(path) { PngBackend.write(image, it) }
    }

    /** The picture as an image; [pixels] is its longer side, 16 to 30000. */
    public fun toImage(pixels: Int): BufferedImage {
        require(pixels in 16..30_000) { "pixels must be from 16 to 30000, not $pixels" }
        return PngBackend.render(scene, pixels / maxOf(width, height))
    }
}
