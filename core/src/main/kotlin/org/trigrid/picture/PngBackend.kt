package org.trigrid.picture

import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.geom.Ellipse2D
import java.awt.geom.Path2D
import java.awt.geom.Rectangle2D
import java.awt.image.BufferedImage
import java.io.IOException
import java.io.OutputStream
import javax.imageio.ImageIO
import javax.imageio.stream.MemoryCacheImageOutputStream

/** Draws a scene on an image; needs no display. */
internal class PngBackend private constructor(private val graphics: Graphics2D) {
    private fun draw(item: SceneItem) {
        when (item) {
            is Triangles -> drawTriangles(item)
            is Strokes -> drawStrokes(item)
            is Area -> drawArea(item)
            is Boxes -> drawBoxes(item)
            is Donuts -> drawDonuts(item)
            is Labels -> drawLabels(item)
        }
    }

    private fun drawTriangles(item: Triangles) {
        graphics.color = Color(item.colour)
        // Without smoothing neighbours meet without a seam; lines and boundary are drawn over the steps.
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF)
        val path = Path2D.Double(Path2D.WIND_NON_ZERO, 4)
        for (i in item.xy.indices step 6) {
            path.reset()
            path.moveTo(item.xy[i], item.xy[i + 1])
            path.lineTo(item.xy[i + 2], item.xy[i + 3])
            path.lineTo(item.xy[i + 4], item.xy[i + 5])
            path.closePath()
            graphics.fill(path)
        }
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
    }

    private fun drawStrokes(item: Strokes) {
        graphics.color = Color(item.colour)
        // Round ends cost much more than the line, and cannot be seen on thin ones.
        val thin = item.lineWidth * graphics.transform.scaleX < THIN
        val cap = if (thin) BasicStroke.CAP_BUTT else BasicStroke.CAP_ROUND
        graphics.stroke = BasicStroke(item.lineWidth.toFloat(), cap, BasicStroke.JOIN_ROUND)
        // Many lines a path save set-up time; too many in one slow the rasteriser's sorting down.
        val path = Path2D.Double(Path2D.WIND_NON_ZERO, 2 * LINES_A_PATH)
        for (i in item.xy.indices step 4) {
            path.moveTo(item.xy[i], item.xy[i + 1])
            path.lineTo(item.xy[i + 2], item.xy[i + 3])
            if ((i / 4 + 1) % LINES_A_PATH == 0) {
                graphics.draw(path)
                path.reset()
            }
        }
        graphics.draw(path)
    }

    private fun drawArea(item: Area) {
        val path = Path2D.Double(Path2D.WIND_EVEN_ODD)
        for (walk in item.walks) {
            path.moveTo(walk[0], walk[1])
            for (i in 2 until walk.size step 2) path.lineTo(walk[i], walk[i + 1])
            path.closePath()
        }
        graphics.color = Color(item.colour)
        graphics.fill(path)
    }

    private fun drawBoxes(item: Boxes) {
        graphics.color = Color(item.colour)
        val box = Rectangle2D.Double()
        for (i in item.xywh.indices step 4) {
            box.setRect(item.xywh[i], item.xywh[i + 1], item.xywh[i + 2], item.xywh[i + 3])
            graphics.fill(box)
        }
    }

    private fun drawDonuts(item: Donuts) {
        val disc = Ellipse2D.Double()
        for (i in item.xyr.indices step 3) {
            val radius = item.xyr[i + 2]
            for (part in 0..1) {
                val r = if (part == 0) radius else (1 - Donuts.RING) * radius
                disc.setFrame(item.xyr[i] - r, item.xyr[i + 1] - r, 2 * r, 2 * r)
                graphics.color = if (part == 0) Color(item.colour) else Color(Palette.PAPER)
                graphics.fill(disc)
            }
        }
    }

    private fun drawLabels(item: Labels) {
        graphics.color = Color(item.colour)
        graphics.font = Font(Font.SANS_SERIF, if (item.bold) Font.BOLD else Font.PLAIN, 1).deriveFont(item.size.toFloat())
        val metrics = graphics.fontMetrics
        for (label in item.labels) {
            val width = metrics.getStringBounds(label.text, graphics).width
            val x = when (label.anchor) {
                Anchor.START -> label.x
                Anchor.MIDDLE -> label.x - 0.5 * width
                Anchor.END -> label.x - width
            }
            if (item.halo) drawHalo(label.text, x, label.y, item)
            graphics.drawString(label.text, x.toFloat(), label.y.toFloat())
        }
    }

    private fun drawHalo(text: String, x: Double, y: Double, item: Labels) {
        val outline = graphics.font.createGlyphVector(graphics.fontRenderContext, text).getOutline(x.toFloat(), y.toFloat())
        graphics.color = Color(Palette.PAPER)
        graphics.stroke = BasicStroke((Labels.HALO * item.size).toFloat(), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
        graphics.draw(outline)
        graphics.color = Color(item.colour)
    }

    companion object {
        private const val LINES_A_PATH = 64

        /** Pixels. */
        private const val THIN = 1.5

        fun render(scene: Scene, scale: Double): BufferedImage {
            val width = maxOf(1, Math.round(scene.width * scale).toInt())
            val height = maxOf(1, Math.round(scene.height * scale).toInt())
            val image = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
            val graphics = image.createGraphics()
            try {
                graphics.color = Color(Palette.PAPER)
                graphics.fillRect(0, 0, width, height)
                graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
                graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
                graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON)
                graphics.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON)
                graphics.scale(scale, scale)
                val backend = PngBackend(graphics)
                val letters = hasFonts(graphics)
                for (item in scene.items) if (item !is Labels || letters) backend.draw(item)
            } finally {
                graphics.dispose()
            }
            return image
        }

        /** Small server images of the JRE come without fonts; AWT then fails with an error of one kind or another. */
        private fun hasFonts(graphics: Graphics2D): Boolean = try {
            graphics.getFontMetrics(Font(Font.SANS_SERIF, Font.PLAIN, 12)).stringWidth("0") > 0
        } catch (_: RuntimeException) {
            false
        } catch (_: LinkageError) {
            false
        } catch (_: InternalError) {
            false
        }

        fun write(image: BufferedImage, out: OutputStream) {
            val writers = ImageIO.getImageWritersByFormatName("png")
            if (!writers.hasNext()) throw IOException("this Java runtime cannot write PNG")
            val writer = writers.next()
            try {
                MemoryCacheImageOutputStream(out).use {
                    writer.output = it
                    writer.write(image)
                }
            } finally {
                writer.dispose()
            }
        }
    }
}
