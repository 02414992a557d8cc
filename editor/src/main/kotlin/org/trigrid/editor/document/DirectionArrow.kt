package org.trigrid.editor.document

import org.trigrid.geometry.Point2

/** The arrow in the middle of a run of segments of one shape or loop: it shows the way the run is travelled. */
internal class DirectionArrow(
    val outline: Outline,
    /** The step on which it sits. */
    val step: Int,
    val from: Point2,
    val to: Point2,
) {
    val place: Point2 = Point2((from.x + to.x) / 2, (from.y + to.y) / 2)

    /** The shape that a click on it turns round, or -1: loops and straight steps between shapes have no direction of their own. */
    val shape: Int get() = outline.shapes[step]

    companion object {
        fun of(document: EditorDocument): List<DirectionArrow> {
            val arrows = ArrayList<DirectionArrow>()
            for (outline in document.outlines) {
                var step = 0
                while (step < outline.stepCount) {
                    var end = step + 1
                    while (end < outline.stepCount && outline.shapes[end] == outline.shapes[step]) end++
                    val middle = (step + end - 1) / 2
                    val from = document.nodes.point(outline.nodes[middle])
                    arrows.add(DirectionArrow(outline, middle, from, document.nodes.point(outline.stepEnd(middle))))
                    step = end
                }
            }
            return arrows
        }

        /** The arrow within [reach] of a place, of those that turn a closed shape round; else null. */
        fun at(document: EditorDocument, x: Double, y: Double, reach: Double): DirectionArrow? = document.arrows
            .filter { it.shape >= 0 && document.path.shape(it.shape).isClosed() }
            .minByOrNull { Math.hypot(it.place.x - x, it.place.y - y) }
            ?.takeIf { Math.hypot(it.place.x - x, it.place.y - y) <= reach }
    }
}
