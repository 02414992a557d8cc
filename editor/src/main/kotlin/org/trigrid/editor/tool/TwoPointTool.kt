package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/** Takes two points and hands them on, as for measuring, mirroring and scaling the picture behind. */
internal class TwoPointTool(
    private val host: ToolHost,
    override val label: String,
    private val firstHint: String,
    private val secondHint: String,
    private val done: (Point2, Point2) -> Unit,
) : Tool {
    private var first: Point2? = null

    override var preview: Preview = Preview.NOTHING
        private set

    override val hint: String get() = if (first == null) firstHint else secondHint

    override val lastPoint: Point2? get() = first

    override fun move(input: PointerInput) = show(host.snapper.snap(input, first))

    override fun drag(input: PointerInput) = move(input)

    override fun press(input: PointerInput) {
        if (input.clickCount == 1) typed(host.snapper.snap(input, first).point)
    }

    override fun typed(point: Point2) {
        val begin = first
        if (begin == null) {
            first = point
            show(SnapPoint(point, SnapKind.NONE))
        } else if (begin != point) {
            first = null
            preview = Preview.NOTHING
            done(begin, point)
        }
    }

    override fun cancel(): Boolean {
        if (first == null) host.leaveTool()
        first = null
        preview = Preview.NOTHING
        return true
    }

    private fun show(at: SnapPoint) {
        val begin = first
        if (begin == null) {
            preview = Preview(snap = at)
            return
        }
        val length = Figures.length(begin.distanceTo(at.point))
        val angle = Figures.angle(Math.toDegrees(Math.atan2(at.point.y - begin.y, at.point.x - begin.x)))
        preview = Preview(
            guides = listOf(doubleArrayOf(begin.x, begin.y, at.point.x, at.point.y)),
            snap = at, marks = listOf(begin), measure = "length $length, angle $angle",
        )
    }
}
