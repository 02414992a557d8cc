package org.trigrid.editor.canvas

import javafx.scene.canvas.GraphicsContext
import javafx.scene.paint.Color
import javafx.scene.text.Font
import org.trigrid.editor.document.DirectionArrow
import org.trigrid.editor.document.EditorDocument
import org.trigrid.editor.document.Outline
import org.trigrid.editor.document.Selection
import org.trigrid.editor.session.ViewSettings

/** Draws the boundary: its segments in the colours of their groups, its nodes as donuts, the way it runs. */
internal class OutlinePainter(
    private val g: GraphicsContext,
    private val view: ViewTransform,
    private val width: Double,
    private val height: Double,
    private val colours: CanvasColours,
    private val document: EditorDocument,
    private val selection: Selection,
) {
    private val nodes = document.nodes
    private val groups = document.groups
    private val onConnectors: Set<Int> = document.onConnectorsOnly

    fun segments() {
        for (outline in document.outlines) {
            var step = 0
            while (step < outline.stepCount) {
                val style = styleOf(outline, step)
                var end = step + 1
                while (end < outline.stepCount && styleOf(outline, end) == style) end++
                run(outline, step, end, style)
                step = end
            }
        }
        g.setLineDashes()
    }

    /** Nodes, with their numbers where there is room; those that are picked always. */
    fun nodes(settings: ViewSettings) {
        val spacing = NodeRoom.of(document, view)
        g.font = Font.font(NUMBER_SIZE)
        for (node in 0 until nodes.count) {
            val isPicked = node in selection.nodes
            if (!isPicked && (!settings.showNodes || spacing.room(node) < LEAST_ROOM)) continue
            val x = view.screenX(nodes.x(node))
            val y = view.screenY(nodes.y(node))
            if (x < -MARGIN || y < -MARGIN || x > width + MARGIN || y > height + MARGIN) continue
            donut(x, y, if (isPicked) colours.accent else if (node in onConnectors) colours.connector else colours.node, if (isPicked) PICKED_DONUT else Math.min(DONUT, spacing.room(node) / 2.2))
            if (settings.showNumbers && (isPicked || spacing.room(node) > NUMBER_ROOM)) {
                val ink = if (isPicked) colours.accent else colours.text
                NumberText.draw(g, node.toString(), x + NUMBER_SHIFT, y - NUMBER_SHIFT, ink, colours.sheet)
            }
        }
    }

    /** An arrow in the middle of each shape and loop. */
    fun directions() {
        for (arrow in document.arrows) arrow(arrow, styleOf(arrow.outline, arrow.step))
    }

    private class Style(val colour: Color, val isDashed: Boolean, val isPicked: Boolean) {
        override fun equals(other: Any?): Boolean =
            other is Style && other.colour == colour && other.isDashed == isDashed && other.isPicked == isPicked

        override fun hashCode(): Int = colour.hashCode()
    }

    private fun styleOf(outline: Outline, step: Int): Style {
        val shape = outline.shapes[step]
        val isPicked = shape >= 0 && shape in selection.shapes || outline.loop in selection.loops
        val isConnector = shape >= 0 && document.path.isConnector(shape)
        val colour = if (isConnector) colours.connector else colours.group(outline.tags[step], groups, document.project.colours)
        return Style(colour, isConnector, isPicked)
    }

    private fun run(outline: Outline, from: Int, to: Int, style: Style) {
        val line = ScreenLine(view, width, height)
        for (step in from..to) {
            val node = if (step < outline.nodes.size) outline.nodes[step] else outline.nodes[0]
            line.add(nodes.x(node), nodes.y(node))
        }
        if (style.isDashed) g.setLineDashes(DASH, DASH) else g.setLineDashes()
        if (style.isPicked) {
            g.stroke = colours.accent.deriveColor(0.0, 1.0, 1.0, HALO_STRENGTH)
            g.lineWidth = HALO
            line.stroke(g)
        }
        g.stroke = if (style.isPicked) colours.accent else style.colour
        g.lineWidth = if (style.isDashed) CONNECTOR_WIDTH else LINE_WIDTH
        line.stroke(g)
    }

    private fun donut(x: Double, y: Double, ring: Color, radius: Double) {
        g.fill = colours.nodeFill
        g.stroke = ring
        g.lineWidth = if (radius > SMALL_DONUT) 1.6 else 1.0
        g.fillOval(x - radius, y - radius, 2 * radius, 2 * radius)
        g.strokeOval(x - radius, y - radius, 2 * radius, 2 * radius)
    }

    private fun arrow(arrow: DirectionArrow, style: Style) {
        val dx = (arrow.to.x - arrow.from.x) * view.scale
        val dy = -(arrow.to.y - arrow.from.y) * view.scale
        val length = Math.hypot(dx, dy)
        if (length == 0.0) return
        val x = view.screenX(arrow.place.x)
        val y = view.screenY(arrow.place.y)
        if (x < 0 || y < 0 || x > width || y > height) return
        val ux = dx / length * ARROW
        val uy = dy / length * ARROW
        g.fill = if (style.isPicked) colours.accent else style.colour
        g.fillPolygon(
            doubleArrayOf(x + ux, x - ux * 0.7 - uy * 0.7, x - ux * 0.7 + uy * 0.7),
            doubleArrayOf(y + uy, y - uy * 0.7 + ux * 0.7, y - uy * 0.7 - ux * 0.7), 3,
        )
    }

    private companion object {
        const val LINE_WIDTH = 1.8
        const val CONNECTOR_WIDTH = 1.2
        const val HALO = 7.0
        const val HALO_STRENGTH = 0.28
        const val DASH = 5.0
        const val DONUT = 3.4
        const val SMALL_DONUT = 2.4
        const val PICKED_DONUT = 4.6
        const val ARROW = 6.5
        const val MARGIN = 20.0

        /** Pixels from node to node that donuts and numbers need. */
        const val LEAST_ROOM = 5.0
        const val NUMBER_ROOM = 34.0
        const val NUMBER_SIZE = 10.0
        const val NUMBER_SHIFT = 5.0
    }
}
