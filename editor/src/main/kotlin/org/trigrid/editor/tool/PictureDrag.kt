package org.trigrid.editor.tool

import org.trigrid.editor.command.ProjectCommands
import org.trigrid.geometry.Point2
import org.trigrid.project.Background

/** Drags the picture behind, where it is not locked. */
internal object PictureDrag {
    /** Whether a picture that may be moved lies under a place. */
    fun isOver(host: ToolHost, place: Point2): Boolean {
        val picture = host.state.document.picture?.takeIf { !it.isLocked } ?: return false
        val size = host.pictureSize ?: return false
        val corner = picture.lowerLeft
        val across = picture.placement().apply(Point2(size.x, 0.0))
        val up = picture.placement().apply(Point2(0.0, size.y))
        return share(corner, across, place) in 0.0..1.0 && share(corner, up, place) in 0.0..1.0
    }

    /** The picture's outline where it would come to lie, x0, y0, x1, y1, …, closed. */
    fun frame(host: ToolHost, from: Point2, to: Point2): DoubleArray {
        val picture = host.state.document.picture ?: return DoubleArray(0)
        val size = host.pictureSize ?: return DoubleArray(0)
        val placement = moved(picture, from, to).placement()
        val corners = listOf(Point2(0.0, 0.0), Point2(size.x, 0.0), size, Point2(0.0, size.y), Point2(0.0, 0.0)).map { placement.apply(it) }
        return DoubleArray(2 * corners.size) { if (it % 2 == 0) corners[it / 2].x else corners[it / 2].y }
    }

    fun drop(host: ToolHost, from: Point2, to: Point2, slack: Double) {
        val picture = host.state.document.picture ?: return
        if (from.distanceTo(to) >= slack) host.execute(ProjectCommands.picture("move picture", moved(picture, from, to)))
    }

    private fun moved(picture: Background, from: Point2, to: Point2): Background =
        picture.withLowerLeft(Point2(picture.lowerLeft.x + to.x - from.x, picture.lowerLeft.y + to.y - from.y))

    /** How far along the line from [a] to [b] the foot of [p] lies. */
    private fun share(a: Point2, b: Point2, p: Point2): Double {
        val ux = b.x - a.x
        val uy = b.y - a.y
        return ((p.x - a.x) * ux + (p.y - a.y) * uy) / (ux * ux + uy * uy)
    }
}
