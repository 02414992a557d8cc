package org.trigrid.editor.tool

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.command.AppendConnector
import org.trigrid.editor.command.AppendShape
import org.trigrid.editor.document.ShapeEdits
import org.trigrid.geometry.Point2
import org.trigrid.shape.Line
import org.trigrid.shape.Shape

/** Draws shapes of one kind, point by point, one after the other. */
internal class ShapeTool(private val host: ToolHost, val kind: ShapeKind) : Tool {
    private val points = ArrayList<Point2>()
    private var cursor: SnapPoint? = null
    private var sides = 6
    private var refusal = ""

    /** Whether the first point is the end of the walk, which Backspace does not take. */
    private var isJoined = false

    override var preview: Preview = Preview.NOTHING
        private set

    override val label: String get() = kind.label

    override val hint: String get() = if (refusal.isNotEmpty()) refusal else kind.hint(points.size)

    override val lastPoint: Point2? get() = points.lastOrNull() ?: host.state.document.path.end()

    init {
        join()
    }

    override fun move(input: PointerInput) {
        cursor = snapped(input)
        show()
    }

    override fun press(input: PointerInput) {
        if (input.clickCount > 1) {
            if (kind.clicks == 0 && points.size >= kind.least) finish(false)
            return
        }
        val snap = snapped(input)
        cursor = snap
        add(snap.point)
    }

    override fun drag(input: PointerInput) = move(input)

    override fun typed(point: Point2) {
        cursor = SnapPoint(point, SnapKind.NONE)
        add(point)
    }

    override fun enter(): Boolean {
        if (kind.clicks != 0 || points.size < kind.least) return false
        finish(false)
        return true
    }

    override fun backspace(): Boolean {
        if (points.size <= (if (isJoined) 1 else 0)) return false
        points.removeAt(points.size - 1)
        refusal = ""
        show()
        return true
    }

    override fun cancel(): Boolean {
        if (points.size > (if (isJoined) 1 else 0)) {
            points.clear()
            join()
            show()
        } else {
            host.leaveTool()
        }
        return true
    }

    override fun count(change: Int): Boolean {
        if (kind != ShapeKind.REGULAR_POLYGON) return false
        sides = (sides + change).coerceIn(LEAST_SIDES, MOST_SIDES)
        show()
        return true
    }

    override fun documentChanged() {
        if (points.size <= 1) {
            points.clear()
            join()
        }
        show()
    }

    private fun snapped(input: PointerInput): SnapPoint = host.snapper.snap(input, points.lastOrNull(), points)

    /** Begins at the end of an open walk; a connector at the end of any walk. */
    private fun join() {
        val path = host.state.document.path
        val goesOn = kind.isOpen && (kind == ShapeKind.CONNECTOR || ShapeEdits.isWalkOpen(path))
        val end = if (goesOn) path.end() else null
        isJoined = end != null
        if (end != null) points.add(end)
    }

    private fun add(point: Point2) {
        refusal = ""
        val isFirstAgain = points.size >= CLOSED_LEAST && ShapeEdits.isAt(point, points.first())
        val mayClose = kind == ShapeKind.POLYGON || kind == ShapeKind.CURVE && !isJoined
        if (isFirstAgain && mayClose) return finish(true)
        if (points.isNotEmpty() && ShapeEdits.isAt(point, points.last())) return
        points.add(point)
        val closesWalk = kind.clicks == 0 && kind.isOpen && endsWalk(point)
        if (points.size == kind.clicks || closesWalk) finish(false) else show()
    }

    /** Whether a click at [point] ends the walk where it began. */
    private fun endsWalk(point: Point2): Boolean {
        val start = if (isJoined) ShapeEdits.openStart(host.state.document.path) else points.first()
        return points.size > 2 && start != null && ShapeEdits.isAt(point, start)
    }

    private fun finish(isClosed: Boolean) {
        val shape = try {
            make(points, isClosed)
        } catch (error: TriGridException) {
            return refuse(error)
        }
        if (shape == null) return
        val command = if (kind == ShapeKind.CONNECTOR) AppendConnector(shape as Line) else AppendShape(shape, kind.label.lowercase())
        if (!host.execute(command)) {
            points.removeAt(points.size - 1)
            return show()
        }
        points.clear()
        join()
        show()
    }

    private fun refuse(error: TriGridException) {
        points.removeAt(points.size - 1)
        refusal = error.message.orEmpty()
        show()
    }

    private fun make(through: List<Point2>, isClosed: Boolean): Shape? {
        val defaults = host.state.document.project.defaults
        return kind.make(through, defaults.spacing, sides, isClosed)?.let { defaults.applyTo(it) }
    }

    private fun show() {
        val at = cursor
        val through = if (at == null || points.lastOrNull()?.let { ShapeEdits.isAt(it, at.point) } == true) points else points + at.point
        val nodes = try {
            make(through, false)?.explode() ?: DoubleArray(0)
        } catch (_: TriGridException) {
            DoubleArray(0)
        }
        val guide = if (hasCentre && through.size == 2) listOf(flat(through)) else emptyList()
        val lines = if (nodes.isNotEmpty()) listOf(nodes) else if (through.size > 1 && !hasCentre) listOf(flat(through)) else emptyList()
        preview = Preview(lines, nodes, guide, snap = at, marks = points.toList(), measure = measure(at?.point))
    }

    private val hasCentre: Boolean get() = kind == ShapeKind.CIRCLE || kind == ShapeKind.REGULAR_POLYGON || kind == ShapeKind.ELLIPSE

    private fun measure(to: Point2?): String {
        val from = points.lastOrNull() ?: return ""
        if (to == null || ShapeEdits.isAt(from, to)) return ""
        val dx = to.x - from.x
        val dy = to.y - from.y
        if (kind == ShapeKind.RECTANGLE || kind == ShapeKind.ELLIPSE) return "${Figures.length(Math.abs(dx))} × ${Figures.length(Math.abs(dy))}"
        val word = if (kind == ShapeKind.CIRCLE) "radius" else "length"
        return "$word ${Figures.length(Math.hypot(dx, dy))}, angle ${Figures.angle(Math.toDegrees(Math.atan2(dy, dx)))}"
    }

    private fun flat(through: List<Point2>): DoubleArray =
        DoubleArray(2 * through.size) { if (it % 2 == 0) through[it / 2].x else through[it / 2].y }

    private companion object {
        const val LEAST_SIDES = 3
        const val MOST_SIDES = 200
        const val CLOSED_LEAST = 3
    }
}
