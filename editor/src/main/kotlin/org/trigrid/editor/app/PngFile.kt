package org.trigrid.editor.app

import javafx.scene.image.Image
import javafx.scene.image.PixelFormat
import java.awt.image.BufferedImage
import java.io.IOException
import java.nio.file.Path
import javax.imageio.ImageIO

/** Images of the window to and from others. */
internal object PngFile {
    @Throws(IOException::class)
    fun write(image: Image, file: Path) {
        val width = image.width.toInt()
        val height = image.height.toInt()
        val pixels = IntArray(width * height)
        image.pixelReader.getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), pixels, 0, width)
        val picture = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
        picture.setRGB(0, 0, width, height, pixels, 0, width)
        if (!ImageIO.write(picture, "png", file.toFile())) throw IOException("no PNG writer")
    }

    /** A picture of the library as one that a window can show. */
    fun toFx(picture: BufferedImage): Image {
        val image = javafx.scene.image.WritableImage(picture.width, picture.height)
        val pixels = picture.getRGB(0, 0, picture.width, picture.height, null, 0, picture.width)
        image.pixelWriter.setPixels(0, 0, picture.width, picture.height, PixelFormat.getIntArgbInstance(), pixels, 0, picture.width)
        return image
    }
}
