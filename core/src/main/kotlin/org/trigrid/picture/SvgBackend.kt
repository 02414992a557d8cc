package org.trigrid.picture

import org.trigrid.io.TextBuffer
import java.io.OutputStream
import java.util.Locale

/** Writes a scene as SVG 1.1: one path for all things that look alike, places to 1/100 of a unit. */
internal class SvgBackend private constructor(private val text: TextBuffer) {
    private fun write(scene: Scene) {
        text.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").place(scene.width)
        text.text("\" height=\"").place(scene.height).text("\" viewBox=\"0 0 ")
        text.place(scene.width).space().place(scene.height).line("\">")
        text.text("<rect width=\"100%\" height=\"100%\" fill=\"").colour(Palette.PAPER).line("\"/>")
        for (item in scene.items) {
            when (item) {
                is Triangles -> writeTriangles(item)
                is Strokes -> writeStrokes(item)
                is Area -> writeArea(item)
                is Boxes -> writeBoxes(item)
                is Donuts -> writeDonuts(item)
                is Labels -> writeLabels(item)
            }
        }
        text.line("</svg>")
        text.flush()
    }

    private fun writeTriangles(item: Triangles) {
        // A hair line of the same colour closes the seams that smoothing leaves between neighbours.
        text.text("<path fill=\"").colour(item.colour).text("\" stroke=\"").colour(item.colour)
        text.text("\" stroke-width=\"0.3\" stroke-linejoin=\"round\" d=\"")
        val pen = Pen()
        for (i in item.xy.indices step 6) {
            pen.moveTo(item.xy[i], item.xy[i + 1])
            pen.lineTo(item.xy[i + 2], item.xy[i + 3])
            pen.lineTo(item.xy[i + 4], item.xy[i + 5])
            pen.close()
            if (i % 60 == 54) text.line()
        }
        text.line("\"/>")
    }

    private fun writeStrokes(item: Strokes) {
        text.text("<path fill=\"none\" stroke=\"").colour(item.colour).text("\" stroke-width=\"").place(item.lineWidth)
        text.text("\" stroke-linecap=\"round\" d=\"")
        val pen = Pen()
        for (i in item.xy.indices step 4) {
            pen.moveTo(item.xy[i], item.xy[i + 1])
            pen.lineTo(item.xy[i + 2], item.xy[i + 3])
            if (i % 64 == 60) text.line()
        }
        text.line("\"/>")
    }

    private fun writeArea(item: Area) {
        text.text("<path fill-rule=\"evenodd\" fill=\"").colour(item.colour).text("\" d=\"")
        for (walk in item.walks) {
            for (i in walk.indices step 2) text.text(if (i == 0) "M" else "L").place(walk[i]).space().place(walk[i + 1])
            text.line("z")
        }
        text.line("\"/>")
    }

    private fun writeBoxes(item: Boxes) {
        text.text("<path shape-rendering=\"crispEdges\" fill=\"").colour(item.colour).text("\" d=\"")
        for (i in item.xywh.indices step 4) {
            text.text("M").place(item.xywh[i]).space().place(item.xywh[i + 1])
            text.text("h").place(item.xywh[i + 2]).text("v").place(item.xywh[i + 3]).text("h").place(-item.xywh[i + 2]).text("z")
            if (i % 64 == 60) text.line()
        }
        text.line("\"/>")
    }

    private fun writeDonuts(item: Donuts) {
        text.text("<g fill=\"#ffffff\" stroke=\"").colour(item.colour).line("\">")
        for (i in item.xyr.indices step 3) {
            val ring = Donuts.RING * item.xyr[i + 2]
            text.text("<circle cx=\"").place(item.xyr[i]).text("\" cy=\"").place(item.xyr[i + 1])
            text.text("\" r=\"").place(item.xyr[i + 2] - 0.5 * ring).text("\" stroke-width=\"").place(ring).line("\"/>")
        }
        text.line("</g>")
    }

    private fun writeLabels(item: Labels) {
        text.text("<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"").place(item.size)
        if (item.bold) text.text("\" font-weight=\"bold")
        if (item.halo) {
            text.text("\" paint-order=\"stroke\" stroke-linejoin=\"round\" stroke=\"").colour(Palette.PAPER)
            text.text("\" stroke-width=\"").place(Labels.HALO * item.size)
        }
        text.text("\" fill=\"").colour(item.colour).line("\">")
        for (label in item.labels) {
            text.text("<text x=\"").place(label.x).text("\" y=\"").place(label.y)
            when (label.anchor) {
                Anchor.START -> {}
                Anchor.MIDDLE -> text.text("\" text-anchor=\"middle")
                Anchor.END -> text.text("\" text-anchor=\"end")
            }
            text.text("\" xml:space=\"preserve\">").escaped(label.text).line("</text>")
        }
        text.line("</g>")
    }

    /** Writes path steps relative to the last place, in whole hundredths so that no error adds up. */
    private inner class Pen {
        private var x = 0L
        private var y = 0L
        private var startX = 0L
        private var startY = 0L

        fun moveTo(toX: Double, toY: Double) {
            step("m", toX, toY)
            startX = x
            startY = y
        }

        fun lineTo(toX: Double, toY: Double) = step("l", toX, toY)

        fun close() {
            text.text("z")
            x = startX
            y = startY
        }

        private fun step(command: String, toX: Double, toY: Double) {
            val newX = Math.round(toX * 100)
            val newY = Math.round(toY * 100)
            text.text(command).number((newX - x) / 100.0)
            if (newY >= y) text.space()
            text.number((newY - y) / 100.0)
            x = newX
            y = newY
        }
    }

    private fun TextBuffer.place(value: Double): TextBuffer = number(Math.rint(value * 100) / 100)

    private fun TextBuffer.colour(rgb: Int): TextBuffer = text("#" + "%06x".format(Locale.ROOT, rgb))

    /** Markup characters and everything outside ASCII by their codes; control characters are dropped. */
    private fun TextBuffer.escaped(line: String): TextBuffer {
        for (code in line.codePoints().toArray()) {
            when {
                code < 32 || code in 0xD800..0xDFFF || code == 0xFFFE || code == 0xFFFF -> {}
                code > 126 || code.toChar() in "<>&\"'" -> text("&#").number(code).text(";")
                else -> text(code.toChar().toString())
            }
        }
        return this
    }

    companion object {
        fun write(scene: Scene, out: OutputStream) = SvgBackend(TextBuffer(out)).write(scene)
    }
}
