package org.trigrid.editor.tool

import org.trigrid.geometry.Point2

/** Takes one point after the other and hands each on. */
internal class PlaceTool(
    private val host: ToolHost,
    override val label: String,
    override val hint: String,
    private val done: (Point2) -> Unit,
) : Tool {
    override var preview: Preview = Preview.NOTHING
        private set

    override fun move(input: PointerInput) {
        preview = Preview(snap = host.snapper.snap(input))
    }

    override fun press(input: PointerInput) {
        if (input.clickCount == 1) done(host.snapper.snap(input).point)
    }

    override fun typed(point: Point2) = done(point)

    override fun cancel(): Boolean {
        host.leaveTool()
        return true
    }
}
