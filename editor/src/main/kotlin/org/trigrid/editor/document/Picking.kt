package org.trigrid.editor.document

import org.trigrid.geometry.Point2

/** A segment near a place: the step [step] of [outline], and the [point] of it that is nearest. */
internal class PickedSegment(val outline: Outline, val step: Int, val point: Point2, val distance: Double) {
    val from: Int get() = outline.nodes[step]
    val to: Int get() = outline.stepEnd(step)

    /** The shape or loop that the segment belongs to. */
    fun selection(): Selection = when {
        outline.loop >= 0 -> Selection.ofLoop(outline.loop)
        outline.shapes[step] >= 0 -> Selection.ofShape(outline.shapes[step])
        else -> Selection.NONE
    }
}

/** Finds what lies under the mouse. Distances are in the domain's unit. */
internal object Picking {
    /** The nearest node within [reach], or -1. */
    fun node(document: EditorDocument, x: Double, y: Double, reach: Double, except: Set<Int> = emptySet()): Int {
        val nodes = document.nodes
        var best = -1
        var bestDistance = reach
        for (node in 0 until nodes.count) {
            val dx = nodes.x(node) - x
            val dy = nodes.y(node) - y
            if (Math.abs(dx) > reach || Math.abs(dy) > reach) continue
            val distance = Math.hypot(dx, dy)
            if (distance <= bestDistance && node !in except) {
                best = node
                bestDistance = distance
            }
        }
        return best
    }

    /** The nearest segment within [reach], or null. */
    fun segment(document: EditorDocument, x: Double, y: Double, reach: Double): PickedSegment? {
        var best: PickedSegment? = null
        val nodes = document.nodes
        for (outline in document.outlines) {
            for (step in 0 until outline.stepCount) {
                val a = outline.nodes[step]
                val b = outline.stepEnd(step)
                if (minOf(nodes.x(a), nodes.x(b)) - reach > x || maxOf(nodes.x(a), nodes.x(b)) + reach < x) continue
                if (minOf(nodes.y(a), nodes.y(b)) - reach > y || maxOf(nodes.y(a), nodes.y(b)) + reach < y) continue
                val foot = nearest(nodes.point(a), nodes.point(b), x, y)
                val distance = Math.hypot(foot.x - x, foot.y - y)
                if (distance <= (best?.distance ?: reach)) best = PickedSegment(outline, step, foot, distance)
            }
        }
        return best
    }

    /** The point of the segment from [a] to [b] that is nearest to (x, y). */
    fun nearest(a: Point2, b: Point2, x: Double, y: Double): Point2 {
        val ux = b.x - a.x
        val uy = b.y - a.y
        val square = ux * ux + uy * uy
        if (square == 0.0) return a
        val t = (((x - a.x) * ux + (y - a.y) * uy) / square).coerceIn(0.0, 1.0)
        return Point2(a.x + t * ux, a.y + t * uy)
    }

    /** Nodes in the upright rectangle between two corners. */
    fun inRectangle(document: EditorDocument, a: Point2, b: Point2): Set<Int> {
        val nodes = document.nodes
        val xs = minOf(a.x, b.x)..maxOf(a.x, b.x)
        val ys = minOf(a.y, b.y)..maxOf(a.y, b.y)
        return (0 until nodes.count).filterTo(LinkedHashSet()) { nodes.x(it) in xs && nodes.y(it) in ys }
    }

    /** Nodes inside a closed line, by the even-odd rule. */
    fun inLasso(document: EditorDocument, lasso: List<Point2>): Set<Int> {
        val nodes = document.nodes
        return (0 until nodes.count).filterTo(LinkedHashSet()) { isInside(lasso, nodes.x(it), nodes.y(it)) }
    }

    private fun isInside(lasso: List<Point2>, x: Double, y: Double): Boolean {
        var inside = false
        var previous = lasso.last()
        for (point in lasso) {
            val crosses = (point.y > y) != (previous.y > y)
            if (crosses && x < point.x + (y - point.y) / (previous.y - point.y) * (previous.x - point.x)) inside = !inside
            previous = point
        }
        return inside
    }
}
