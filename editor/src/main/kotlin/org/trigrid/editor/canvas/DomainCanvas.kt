package org.trigrid.editor.canvas

import javafx.scene.canvas.Canvas
import javafx.scene.canvas.GraphicsContext
import javafx.scene.layout.Region
import javafx.scene.paint.Color
import org.trigrid.domain.Domain

/** Draws a domain: its segments as lines, its nodes as small donuts. Fits it to the window. */
internal class DomainCanvas : Region() {
    private val canvas = Canvas()

    /** The domain shown, or null for an empty sheet. */
    var domain: Domain? = null
        set(value) {
            field = value
            requestLayout()
        }

    init {
        children.add(canvas)
        setPrefSize(PREFERRED_WIDTH, PREFERRED_HEIGHT)
    }

    override fun layoutChildren() {
        canvas.width = width
        canvas.height = height
        draw(canvas.graphicsContext2D)
    }

    private fun draw(graphics: GraphicsContext) {
        graphics.fill = Color.WHITE
        graphics.fillRect(0.0, 0.0, width, height)
        val shown = domain ?: return
        val view = ViewTransform.fit(Box.of(shown), width, height, MARGIN)
        drawSegments(graphics, shown, view)
        drawNodes(graphics, shown, view)
    }

    private fun drawSegments(graphics: GraphicsContext, shown: Domain, view: ViewTransform) {
        graphics.lineWidth = 1.0
        for (segment in 0 until shown.segmentCount) {
            graphics.stroke = if (shown.isEmbedded(segment)) EMBEDDED else BOUNDARY
            val from = shown.segmentStart(segment)
            val to = shown.segmentEnd(segment)
            graphics.strokeLine(
                view.screenX(shown.x(from)),
                view.screenY(shown.y(from)),
                view.screenX(shown.x(to)),
                view.screenY(shown.y(to)),
            )
        }
    }

    private fun drawNodes(graphics: GraphicsContext, shown: Domain, view: ViewTransform) {
        graphics.stroke = NODE
        graphics.fill = Color.WHITE
        graphics.lineWidth = DONUT_RING
        for (node in 0 until shown.nodeCount) {
            val x = view.screenX(shown.x(node)) - DONUT / 2
            val y = view.screenY(shown.y(node)) - DONUT / 2
            graphics.fillOval(x, y, DONUT, DONUT)
            graphics.strokeOval(x, y, DONUT, DONUT)
        }
    }

    private companion object {
        const val PREFERRED_WIDTH = 900.0
        const val PREFERRED_HEIGHT = 650.0
        const val MARGIN = 30.0
        const val DONUT = 5.0
        const val DONUT_RING = 1.5
        val BOUNDARY: Color = Color.web("#30506e")
        val EMBEDDED: Color = Color.web("#9a6a20")
        val NODE: Color = Color.web("#b0342c")
    }
}
