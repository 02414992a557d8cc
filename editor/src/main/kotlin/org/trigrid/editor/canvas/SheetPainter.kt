package org.trigrid.editor.canvas

import javafx.scene.canvas.GraphicsContext
import javafx.scene.image.Image
import javafx.scene.paint.Color
import javafx.scene.shape.FillRule
import javafx.scene.transform.Affine
import org.trigrid.domain.Domain
import org.trigrid.editor.tool.Grid
import org.trigrid.geometry.Point2
import org.trigrid.project.Background

/** Draws what lies under the mesh: the sheet, the grid, the picture to trace over. */
internal class SheetPainter(
    private val g: GraphicsContext,
    private val view: ViewTransform,
    private val width: Double,
    private val height: Double,
    private val colours: CanvasColours,
) {
    fun sheet() {
        g.fill = colours.sheet
        g.fillRect(0.0, 0.0, width, height)
    }

    fun grid() {
        val step = Grid.stepFor(view.pixel)
        val strong = Grid.strongEvery(step)
        // Boxes of whole pixels are filled many times faster than lines are stroked.
        lines(step, strong, view.left, view.domainX(width)) { at -> g.fillRect(Math.floor(view.screenX(at)), 0.0, 1.0, height) }
        lines(step, strong, view.domainY(height), view.top) { at -> g.fillRect(0.0, Math.floor(view.screenY(at)), width, 1.0) }
    }

    private fun lines(step: Double, strong: Int, from: Double, to: Double, draw: (Double) -> Unit) {
        val first = Math.ceil(from / step).toLong()
        val last = Math.floor(to / step).toLong()
        if (last - first > MOST_LINES) return
        for (pass in 0..2) {
            g.fill = if (pass == 0) colours.gridFine else if (pass == 1) colours.gridStrong else colours.axis
            for (i in first..last) {
                val kind = if (i == 0L) 2 else if (i % strong == 0L) 1 else 0
                if (kind == pass) draw(i * step)
            }
        }
    }

    /** Pixels of the picture go to the domain by its placement, from there to the screen. */
    fun picture(image: Image, picture: Background) {
        val placement = picture.placement()
        val origin = placement.apply(Point2(0.0, 0.0))
        val right = placement.apply(Point2(1.0, 0.0))
        val up = placement.apply(Point2(0.0, 1.0))
        g.save()
        g.globalAlpha = picture.opacity
        val h = image.height
        // The image counts rows from above, its placement from below.
        val ux = (right.x - origin.x) * view.scale
        val uy = -(right.y - origin.y) * view.scale
        val vx = -(up.x - origin.x) * view.scale
        val vy = (up.y - origin.y) * view.scale
        g.transform(Affine(ux, vx, view.screenX(origin.x) - vx * h, uy, vy, view.screenY(origin.y) - vy * h))
        g.drawImage(image, 0.0, 0.0)
        g.restore()
    }

    /** A shade of the region's colour where the domain is, so that what is left out is seen before there is a mesh. */
    fun region(domain: Domain, colour: Color) {
        if (domain.segmentCount > MOST_SHADED) return
        g.beginPath()
        for (loop in 0 until domain.loopCount) {
            val nodes = domain.loopNodes(loop)
            for ((i, node) in nodes.withIndex()) {
                val x = view.screenX(domain.x(node)).coerceIn(-FAR, FAR)
                val y = view.screenY(domain.y(node)).coerceIn(-FAR, FAR)
                if (i == 0) g.moveTo(x, y) else g.lineTo(x, y)
            }
            g.closePath()
        }
        g.fillRule = FillRule.EVEN_ODD
        g.fill = colour.deriveColor(0.0, 1.0, 1.0, SHADE)
        g.fill()
    }

    private companion object {
        const val MOST_LINES = 2000
        const val MOST_SHADED = 20_000
        const val SHADE = 0.1
        const val FAR = 1e5
    }
}
