package org.trigrid.editor.tool

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.command.InsertNode
import org.trigrid.editor.command.MoveNodes
import org.trigrid.editor.command.ReplaceShape
import org.trigrid.editor.command.ShapeCommands
import org.trigrid.editor.command.TransformSelection
import org.trigrid.editor.document.DirectionArrow
import org.trigrid.editor.document.PickedSegment
import org.trigrid.editor.document.Picking
import org.trigrid.editor.document.Selection
import org.trigrid.editor.document.ShapeHandle
import org.trigrid.editor.document.ShapeHandles
import org.trigrid.geometry.Point2
import org.trigrid.shape.Similarity

/** Picks and moves nodes and shapes. A drag is one step. */
internal class SelectTool(private val host: ToolHost, private val isLasso: Boolean = false) : Tool {
    private enum class Drag { NONE, WAITING, NODES, SHAPES, HANDLE, AREA, PICTURE }

    private var drag = Drag.NONE
    private var pressed = Point2(0.0, 0.0)
    private var anchor = Point2(0.0, 0.0)
    private var grabbed = -1
    private var handle: ShapeHandle? = null
    private val lasso = ArrayList<Point2>()
    private var isOverNode = -1
    private var isOverArrow = false

    override var preview: Preview = Preview.NOTHING
        private set

    override val label: String get() = if (isLasso) "Lasso" else "Select"

    override val hint: String
        get() = when {
            drag == Drag.NODES && isOverNode >= 0 -> "Release to merge with node $isOverNode"
            isOverArrow -> "Click the arrow to turn the shape round: what is included is left out, and the other way about"
            drag == Drag.PICTURE -> "Release to put the picture there; Esc cancels"
            drag == Drag.NODES || drag == Drag.SHAPES || drag == Drag.HANDLE -> "Release to move; Alt suspends snapping, Esc cancels"
            drag == Drag.AREA -> "Release to pick the nodes inside; Shift adds to what is picked"
            host.state.selection.nodes.isNotEmpty() -> "Drag to move, onto another node to merge; Delete removes"
            host.state.selection.isEmpty && host.state.document.picture?.isLocked == false ->
                "Drag the picture, or lock it (menu Picture) to pick nodes over it"
            host.state.selection.isEmpty -> "Click a shape or a node, or drag a box round nodes"
            else -> "Drag to move, a square to reshape; click the arrow to reverse"
        }

    override val lastPoint: Point2? get() = host.state.selection.nodes.singleOrNull()?.let { host.state.document.nodes.point(it) }

    override fun press(input: PointerInput) {
        preview = Preview.NOTHING
        pressed = Point2(input.x, input.y)
        if (input.clickCount == 2) return insert(input)
        val document = host.state.document
        val reach = Snapper.REACH * input.pixel
        handle = handles().minByOrNull { it.point.distanceTo(pressed) }?.takeIf { it.point.distanceTo(pressed) <= reach && !input.isShiftDown }
        grabbed = Picking.node(document, input.x, input.y, reach)
        val arrow = if (grabbed < 0 && handle == null) DirectionArrow.at(document, input.x, input.y, ARROW * input.pixel) else null
        if (arrow != null && !input.isShiftDown) {
            drag = Drag.NONE
            host.select(Selection.ofShape(arrow.shape))
            host.execute(ShapeCommands.reverse(setOf(arrow.shape)))
            return
        }
        if (handle != null) {
            anchor = handle!!.point
            drag = Drag.WAITING
            return
        }
        val segment = if (grabbed >= 0) null else Picking.segment(document, input.x, input.y, reach)
        val hit = if (grabbed >= 0) Selection.ofNode(grabbed) else segment?.selection()
        if (hit == null || hit.isEmpty) {
            startArea(input)
            if (!isLasso && !input.isShiftDown && PictureDrag.isOver(host, pressed)) drag = Drag.PICTURE
            return
        }
        anchor = if (grabbed >= 0) document.nodes.point(grabbed) else nearerEnd(segment!!)
        pick(hit, input.isShiftDown)
        drag = Drag.WAITING
    }

    override fun drag(input: PointerInput) {
        val at = Point2(input.x, input.y)
        if (drag == Drag.WAITING && at.distanceTo(pressed) < SLACK * input.pixel) return
        if (drag == Drag.WAITING) {
            drag = if (handle != null) Drag.HANDLE else if (host.state.selection.nodes.isNotEmpty()) Drag.NODES else Drag.SHAPES
        }
        when (drag) {
            Drag.AREA -> {
                if (isLasso) lasso.add(at) else extend(at)
                preview = Preview(lasso = lasso.toList())
            }
            Drag.PICTURE -> preview = Preview(listOf(PictureDrag.frame(host, pressed, at)))
            Drag.NODES -> showNodes(snapped(input))
            Drag.SHAPES -> showShapes(snapped(input))
            Drag.HANDLE -> showHandle(snapped(input))
            Drag.NONE, Drag.WAITING -> Unit
        }
    }

    override fun release(input: PointerInput) {
        val done = drag
        drag = Drag.NONE
        isOverNode = -1
        preview = Preview.NOTHING
        when (done) {
            Drag.NODES -> moveNodes(snapped(input))
            Drag.SHAPES -> moved(snapped(input)).let { if (!isIdle(it)) host.execute(TransformSelection(it, "move")) }
            Drag.HANDLE -> pull(snapped(input).point)
            Drag.AREA -> pickArea(input)
            Drag.PICTURE -> PictureDrag.drop(host, pressed, Point2(input.x, input.y), SLACK * input.pixel)
            Drag.NONE, Drag.WAITING -> Unit
        }
    }

    override fun move(input: PointerInput) {
        val reach = Snapper.REACH * input.pixel
        val node = Picking.node(host.state.document, input.x, input.y, reach)
        isOverArrow = node < 0 && DirectionArrow.at(host.state.document, input.x, input.y, ARROW * input.pixel) != null
        preview = if (node < 0) Preview.NOTHING else Preview(snap = SnapPoint(host.state.document.nodes.point(node), SnapKind.NODE, node))
    }

    override fun cancel(): Boolean {
        if (drag == Drag.NONE) host.select(Selection.NONE)
        drag = Drag.NONE
        preview = Preview.NOTHING
        return true
    }

    /** A typed place moves the one picked node there. */
    override fun typed(point: Point2) {
        val node = host.state.selection.nodes.singleOrNull() ?: return
        host.execute(MoveNodes(intArrayOf(node), listOf(point)))
    }

    override fun documentChanged() {
        drag = Drag.NONE
        preview = Preview.NOTHING
    }

    private fun handles(): List<ShapeHandle> {
        val shape = host.state.selection.onlyShape
        return if (shape < 0) emptyList() else ShapeHandles.of(host.state.document.path, shape)
    }

    private fun pick(hit: Selection, adds: Boolean) {
        val picked = host.state.selection
        val isPicked = picked.nodes.containsAll(hit.nodes) && picked.shapes.containsAll(hit.shapes) && picked.loops.containsAll(hit.loops)
        if (adds) host.select(picked.toggled(hit)) else if (!isPicked || hit.nodes.isEmpty() && picked.nodes.isNotEmpty()) host.select(hit)
    }

    /** What is snapped while a shape is dragged: a node of it, so that nodes come to lie where nodes belong. */
    private fun nearerEnd(segment: PickedSegment): Point2 {
        val nodes = host.state.document.nodes
        return listOf(nodes.point(segment.from), nodes.point(segment.to)).minByOrNull { it.distanceTo(pressed) }!!
    }

    private fun startArea(input: PointerInput) {
        if (!input.isShiftDown) host.select(Selection.NONE)
        lasso.clear()
        lasso.add(pressed)
        drag = Drag.AREA
    }

    private fun extend(at: Point2) {
        while (lasso.size > 1) lasso.removeAt(lasso.size - 1)
        lasso.add(at)
    }

    private fun pickArea(input: PointerInput) {
        val document = host.state.document
        val at = Point2(input.x, input.y)
        if (at.distanceTo(pressed) < SLACK * input.pixel && lasso.size < LASSO_LEAST) return
        val nodes = if (isLasso) Picking.inLasso(document, lasso) else Picking.inRectangle(document, pressed, at)
        val found = Selection(nodes = nodes)
        host.select(if (input.isShiftDown) host.state.selection.plus(found) else found)
    }

    private fun insert(input: PointerInput) {
        drag = Drag.NONE
        val hit = Picking.segment(host.state.document, input.x, input.y, Snapper.REACH * input.pixel) ?: return
        val isAtNode = Picking.node(host.state.document, input.x, input.y, Snapper.REACH * input.pixel) >= 0
        if (!isAtNode) host.execute(InsertNode(hit.from, hit.to, hit.point))
    }

    private fun snapped(input: PointerInput): SnapPoint {
        val except = if (drag == Drag.SHAPES) nodesOfShapes() else if (drag == Drag.HANDLE) nodesOfShapes() else host.state.selection.nodes
        val shifted = PointerInput(
            input.x + anchor.x - pressed.x, input.y + anchor.y - pressed.y, input.pixel,
            input.isShiftDown, input.isAltDown, input.isControlDown,
        )
        return host.snapper.snap(shifted, anchor, except = except)
    }

    private fun nodesOfShapes(): Set<Int> {
        val nodes = LinkedHashSet<Int>()
        for (shape in host.state.selection.shapes) for (node in host.state.document.path.nodesOf(shape)) nodes.add(node)
        for (outline in host.state.document.outlines) {
            if (outline.loop in host.state.selection.loops) for (node in outline.nodes) nodes.add(node)
        }
        return nodes
    }

    private fun moved(to: SnapPoint): Similarity = Similarity.translation(to.point.x - anchor.x, to.point.y - anchor.y)

    private fun isIdle(similarity: Similarity): Boolean = similarity.apply(anchor) == anchor

    private fun moveNodes(to: SnapPoint) {
        val similarity = moved(to)
        if (isIdle(similarity)) return
        val nodes = host.state.selection.nodes.toIntArray()
        host.execute(MoveNodes(nodes, nodes.map { similarity.apply(host.state.document.nodes.point(it)) }))
    }

    private fun pull(to: Point2) {
        val shape = host.state.selection.onlyShape
        val by = try {
            handle!!.dragged(to)
        } catch (_: TriGridException) {
            return
        }
        if (shape >= 0) host.execute(ReplaceShape(shape, by, handle!!.what))
    }

    private fun showNodes(to: SnapPoint) {
        isOverNode = to.node
        val similarity = moved(to)
        preview = Preview(DragLines.of(host.state.document, host.state.selection.nodes, similarity), snap = to, measure = way(to))
    }

    private fun showShapes(to: SnapPoint) {
        preview = Preview(DragLines.of(host.state.document, nodesOfShapes(), moved(to)), snap = to, measure = way(to))
    }

    private fun showHandle(to: SnapPoint) {
        val nodes = try {
            handle!!.dragged(to.point).explode()
        } catch (_: TriGridException) {
            DoubleArray(0)
        }
        preview = Preview(if (nodes.isEmpty()) emptyList() else listOf(nodes), nodes, snap = to, measure = way(to))
    }

    private fun way(to: SnapPoint): String =
        "moved by ${Figures.length(to.point.x - anchor.x)}, ${Figures.length(to.point.y - anchor.y)}"

    private companion object {
        /** Pixels that the hand may shake. */
        const val SLACK = 3.0
        const val ARROW = 7.0
        const val LASSO_LEAST = 3
    }
}
