package org.trigrid.editor.canvas

import javafx.geometry.VPos
import javafx.scene.canvas.GraphicsContext
import javafx.scene.paint.Color
import javafx.scene.text.Font
import javafx.scene.text.Text
import javafx.scene.text.TextAlignment
import org.trigrid.editor.document.ShapeHandle
import org.trigrid.editor.meshing.Colouring
import org.trigrid.editor.meshing.MeshView
import org.trigrid.editor.meshing.Problem
import org.trigrid.editor.tool.Figures
import org.trigrid.editor.tool.Preview
import org.trigrid.editor.tool.SnapKind
import org.trigrid.editor.tool.SnapPoint
import org.trigrid.spacing.SizeSources

/** Draws what lies over the boundary: the tool's preview, handles, faults, the legend. */
internal class OverlayPainter(
    private val g: GraphicsContext,
    private val view: ViewTransform,
    private val width: Double,
    private val height: Double,
    private val colours: CanvasColours,
) {
    fun preview(preview: Preview) {
        lasso(preview)
        g.setLineDashes(4.0, 4.0)
        g.stroke = colours.muted
        g.lineWidth = 1.0
        for (guide in preview.guides) polyline(guide)
        g.setLineDashes()
        g.stroke = colours.accent
        g.lineWidth = 1.8
        for (line in preview.lines) polyline(line)
        if (preview.nodes.size / 2 in 1..MOST_NODES) futureNodes(preview.nodes)
        g.fill = colours.accent
        for (mark in preview.marks) square(view.screenX(mark.x), view.screenY(mark.y), 3.0)
        preview.snap?.let { snap(it) }
        if (preview.measure.isNotEmpty() && preview.snap != null) measure(preview.measure, preview.snap)
    }

    fun handles(handles: List<ShapeHandle>) {
        for (handle in handles) {
            val x = view.screenX(handle.point.x)
            val y = view.screenY(handle.point.y)
            g.fill = colours.nodeFill
            g.stroke = colours.accent
            g.lineWidth = 1.6
            g.fillRect(x - HANDLE, y - HANDLE, 2 * HANDLE, 2 * HANDLE)
            g.strokeRect(x - HANDLE, y - HANDLE, 2 * HANDLE, 2 * HANDLE)
        }
    }

    /** Places that ask for small elements: a ring of the size asked for, a broken line. */
    fun sources(sources: SizeSources) {
        g.stroke = colours.warning
        g.lineWidth = 1.4
        for (source in 0 until sources.count) {
            val place = sources.placeOf(source)
            val x = view.screenX(place[0])
            val y = view.screenY(place[1])
            g.setLineDashes(SOURCE_DASH, SOURCE_DASH)
            if (place.size > 2) polyline(place)
            g.setLineDashes()
            val radius = (sources.sizeOf(source) * view.scale).coerceIn(LEAST_SOURCE, MOST_SOURCE)
            if (place.size == 2) g.strokeOval(x - radius, y - radius, 2 * radius, 2 * radius)
            g.fill = colours.warning
            square(x, y, 2.5)
            label("size " + Figures.length(sources.sizeOf(source)), x + 9, y - 12, colours.warning)
        }
    }

    fun problems(problems: List<Problem>, emphasised: Problem?) {
        for (problem in problems.take(MOST_PROBLEMS)) {
            if (!problem.isFault && problem !== emphasised) continue
            val x = view.screenX(problem.x)
            val y = view.screenY(problem.y)
            val colour = if (problem.isFault) colours.fault else colours.warning
            val radius = if (problem === emphasised) 14.0 else 8.0
            g.stroke = colour
            g.lineWidth = 2.0
            g.fill = Color.color(colour.red, colour.green, colour.blue, 0.16)
            g.fillOval(x - radius, y - radius, 2 * radius, 2 * radius)
            g.strokeOval(x - radius, y - radius, 2 * radius, 2 * radius)
        }
    }

    /** Outlines elements, such as the worst; those too small for an outline are dots. */
    fun elements(mesh: MeshView, elements: Iterable<Int>) {
        g.stroke = colours.fault
        g.fill = colours.fault
        g.lineWidth = 2.2
        // One path for all: each stroke of its own costs the time of a hundred lines.
        g.beginPath()
        for (element in elements) {
            val xs = DoubleArray(3) { view.screenX(mesh.mesh.x(mesh.mesh.nodeOf(element, it))) }
            val ys = DoubleArray(3) { view.screenY(mesh.mesh.y(mesh.mesh.nodeOf(element, it))) }
            if (xs.max() < 0 || ys.max() < 0 || xs.min() > width || ys.min() > height) continue
            if (xs.max() - xs.min() < DOT && ys.max() - ys.min() < DOT) {
                g.fillRect(Math.floor(xs[0]) - 1, Math.floor(ys[0]) - 1, DOT, DOT)
                continue
            }
            g.moveTo(xs[0], ys[0])
            g.lineTo(xs[1], ys[1])
            g.lineTo(xs[2], ys[2])
            g.closePath()
        }
        g.stroke()
    }

    fun legend(colouring: Colouring, mesh: MeshView) {
        if (colouring == Colouring.NONE) return
        val scale = ColourScale.of(colouring)
        val ends = LegendWords.ends(colouring, scale, mesh)
        val boxWidth = LEGEND_CELL * scale.colours.size
        val left = LEGEND_MARGIN
        val top = height - LEGEND_HEIGHT - LEGEND_MARGIN
        g.fill = colours.panel
        g.fillRoundRect(left, top, boxWidth + 2 * LEGEND_PAD, LEGEND_HEIGHT, 10.0, 10.0)
        g.stroke = colours.gridStrong
        g.lineWidth = 1.0
        g.strokeRoundRect(left + 0.5, top + 0.5, boxWidth + 2 * LEGEND_PAD - 1, LEGEND_HEIGHT - 1, 10.0, 10.0)
        g.font = Font.font(12.0)
        g.fill = colours.text
        g.fillText(LegendWords.title(colouring), left + LEGEND_PAD, top + 19)
        for ((i, colour) in scale.colours.withIndex()) {
            g.fill = Color.rgb(colour shr 16 and 255, colour shr 8 and 255, colour and 255)
            g.fillRect(left + LEGEND_PAD + i * LEGEND_CELL, top + 27, LEGEND_CELL, 12.0)
        }
        g.fill = colours.muted
        g.font = Font.font(10.5)
        g.textAlign = TextAlignment.CENTER
        for ((i, end) in ends.withIndex()) {
            if (end.isNotEmpty()) g.fillText(end, left + LEGEND_PAD + i * LEGEND_CELL, top + 52)
        }
        g.textAlign = TextAlignment.LEFT
    }

    private fun lasso(preview: Preview) {
        val points = preview.lasso
        if (points.size < 2) return
        val a = points.first()
        val b = points.last()
        g.fill = Color.color(colours.accent.red, colours.accent.green, colours.accent.blue, 0.12)
        g.stroke = colours.accent
        g.lineWidth = 1.0
        if (points.size == 2) {
            val left = Math.min(view.screenX(a.x), view.screenX(b.x))
            val top = Math.min(view.screenY(a.y), view.screenY(b.y))
            val w = Math.abs(view.screenX(a.x) - view.screenX(b.x))
            val h = Math.abs(view.screenY(a.y) - view.screenY(b.y))
            g.fillRect(left, top, w, h)
            g.strokeRect(left, top, w, h)
        } else {
            val xs = DoubleArray(points.size) { view.screenX(points[it].x) }
            val ys = DoubleArray(points.size) { view.screenY(points[it].y) }
            g.fillPolygon(xs, ys, xs.size)
            g.strokePolygon(xs, ys, xs.size)
        }
    }

    private fun futureNodes(nodes: DoubleArray) {
        g.stroke = colours.accent
        g.fill = colours.nodeFill
        g.lineWidth = 1.2
        for (i in nodes.indices step 2) {
            val x = view.screenX(nodes[i])
            val y = view.screenY(nodes[i + 1])
            if (x < 0 || y < 0 || x > width || y > height) continue
            g.fillOval(x - 2.5, y - 2.5, 5.0, 5.0)
            g.strokeOval(x - 2.5, y - 2.5, 5.0, 5.0)
        }
    }

    private fun snap(snap: SnapPoint) {
        val x = view.screenX(snap.point.x)
        val y = view.screenY(snap.point.y)
        g.stroke = colours.warning
        g.lineWidth = 1.8
        when (snap.kind) {
            SnapKind.NONE -> return
            SnapKind.GRID, SnapKind.ANGLE -> {
                g.strokeLine(x - 5, y, x + 5, y)
                g.strokeLine(x, y - 5, x, y + 5)
                return
            }
            SnapKind.NODE, SnapKind.END -> g.strokeRect(x - 6, y - 6, 12.0, 12.0)
            SnapKind.MIDDLE -> g.strokePolygon(doubleArrayOf(x, x + 7, x - 7), doubleArrayOf(y - 7, y + 5, y + 5), 3)
            SnapKind.CENTRE -> g.strokeOval(x - 7, y - 7, 14.0, 14.0)
            SnapKind.INTERSECTION -> {
                g.strokeLine(x - 6, y - 6, x + 6, y + 6)
                g.strokeLine(x - 6, y + 6, x + 6, y - 6)
            }
        }
        label(if (snap.node >= 0) "node ${snap.node}" else snap.kind.label, x + 11, y - 11, colours.warning)
    }

    private fun measure(words: String, at: SnapPoint) = label(words, view.screenX(at.point.x) + 14, view.screenY(at.point.y) + 20, colours.text)

    private fun label(words: String, x: Double, y: Double, colour: Color) {
        g.font = Font.font(11.5)
        g.textBaseline = VPos.CENTER
        val room = Text(words).also { it.font = g.font }.layoutBounds.width + 9
        val left = Math.min(x, width - room - 4)
        g.fill = colours.panel
        g.fillRoundRect(left - 4, y - 9, room, 18.0, 6.0, 6.0)
        g.fill = colour
        g.fillText(words, left, y)
        g.textBaseline = VPos.BASELINE
    }

    private fun polyline(points: DoubleArray) {
        val line = ScreenLine(view, width, height)
        for (i in points.indices step 2) line.add(points[i], points[i + 1])
        line.stroke(g)
    }

    private fun square(x: Double, y: Double, half: Double) = g.fillRect(x - half, y - half, 2 * half, 2 * half)

    companion object {
        private const val HANDLE = 4.0
        private const val DOT = 3.0
        private const val SOURCE_DASH = 3.0
        private const val LEAST_SOURCE = 5.0
        private const val MOST_SOURCE = 40.0
        private const val MOST_NODES = 3000
        private const val MOST_PROBLEMS = 300
        private const val LEGEND_CELL = 30.0
        private const val LEGEND_PAD = 22.0
        private const val LEGEND_HEIGHT = 62.0
        private const val LEGEND_MARGIN = 14.0

        /** Pixels at the foot of the sheet that the legend takes. */
        const val LEGEND_ROOM = LEGEND_HEIGHT
    }
}

/** Words of the legend. */
internal object LegendWords {
    fun title(colouring: Colouring): String = when (colouring) {
        Colouring.NONE -> ""
        Colouring.QUALITY -> "Quality (1 is equilateral)"
        Colouring.MIN_ANGLE -> "Smallest angle, degrees"
        Colouring.SIZE -> "Longest edge"
        Colouring.DEGREE -> "Degree is off six by"
    }

    /** What stands at each end of the classes, from the lower end of the first. */
    fun ends(colouring: Colouring, scale: ColourScale, mesh: MeshView): List<String> {
        val inner = scale.ends.toList()
        return when (colouring) {
            Colouring.NONE -> emptyList()
            Colouring.QUALITY -> listOf("0") + inner.map { Figures.plain(it, 2) } + "1"
            Colouring.MIN_ANGLE -> listOf("0") + inner.map { Figures.plain(it * MeshView.EQUILATERAL, 3) } + "60"
            Colouring.SIZE -> (listOf(0.0) + inner + 1.0).mapIndexed { i, level ->
                val size = mesh.sizes[0] * Math.pow(mesh.sizes[1] / mesh.sizes[0], level)
                if (i % 2 == 0) Figures.plain(size, 3) else ""
            }
            Colouring.DEGREE -> listOf("4 +", "", "", "", "", "0")
        }
    }
}
