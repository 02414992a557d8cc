package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.SegmentTree

/**
 * Finds the triangle of a place in a domain's triangulation by walking there from a triangle near by.
 *
 * The walk first crosses any side that the place lies beyond. In a domain that is not convex this may lead into a dead
 * end at the boundary; then a straight walk from the first triangle's middle is tried. A place that the second one does not
 * reach either is looked up in a tree of the triangles' boxes, made when it is first needed: behind a hole must not count as
 * outside, since the wrong triangle would be the next walk's start. The answer for a place that is outside is the triangle
 * where the first walk ended.
 *
 * Plain doubles: a place within rounding of a side may be given to either triangle. Always ends, at the latest after as
 * many steps as there are triangles.
 */
internal class TriangleWalk(private val mesh: ConstrainedDelaunay, private val checkpoint: Checkpoint = Checkpoint.unheard()) {
    private val xy = mesh.xy
    private val nodes = mesh.nodes
    private val twins = mesh.twins
    private val stepLimit = mesh.triangleCount + 8
    private val tree by lazy(LazyThreadSafetyMode.NONE) { boxTree() }

    /** Weights of the corners of the last found triangle, before division by their sum; negative beyond a side. */
    var weight0 = 0.0
        private set
    var weight1 = 0.0
        private set
    var weight2 = 0.0
        private set

    /** Whether the last place was found inside of the triangle answered. */
    var reached = false
        private set

    /** Triangle that holds ([x], [y]), seen from triangle [start]. */
    fun find(x: Double, y: Double, start: Int): Int {
        val triangle = freeWalk(x, y, start)
        if (reached) return triangle
        val second = straightWalk(x, y, start)
        if (reached) return second
        val third = lookUp(x, y)
        return if (reached) third else triangle.also { weigh(it, x, y) }
    }

    private fun lookUp(x: Double, y: Double): Int {
        var found = -1
        tree.forEachIn(x, y, x, y) { t ->
            if (found < 0) {
                weigh(t, x, y)
                if (weight0 >= 0 && weight1 >= 0 && weight2 >= 0) found = t
            }
        }
        reached = found >= 0
        return found
    }

    /** A segment from corner to corner of each triangle's box. */
    private fun boxTree(): SegmentTree {
        val corners = DoubleArray(4 * mesh.triangleCount) { i ->
            checkpoint.pass()
            val axis = i and 1
            val first = xy[2 * nodes[3 * (i / 4)] + axis]
            val second = xy[2 * nodes[3 * (i / 4) + 1] + axis]
            val third = xy[2 * nodes[3 * (i / 4) + 2] + axis]
            if (i and 2 == 0) Math.min(first, Math.min(second, third)) else Math.max(first, Math.max(second, third))
        }
        return SegmentTree(corners, IntArray(2 * mesh.triangleCount) { it }, checkpoint)
    }

    private fun freeWalk(x: Double, y: Double, start: Int): Int {
        var t = start
        for (step in 0 until stepLimit) {
            weigh(t, x, y)
            val e = 3 * t
            val across = when {
                weight2 < 0 && twins[e] >= 0 -> twins[e]
                weight0 < 0 && twins[e + 1] >= 0 -> twins[e + 1]
                weight1 < 0 && twins[e + 2] >= 0 -> twins[e + 2]
                else -> break
            }
            t = across / 3
        }
        reached = weight0 >= 0 && weight1 >= 0 && weight2 >= 0
        return t
    }

    private fun weigh(t: Int, x: Double, y: Double) {
        val a = 2 * nodes[3 * t]
        val b = 2 * nodes[3 * t + 1]
        val c = 2 * nodes[3 * t + 2]
        val ax = xy[a] - x
        val ay = xy[a + 1] - y
        val bx = xy[b] - x
        val by = xy[b + 1] - y
        val cx = xy[c] - x
        val cy = xy[c + 1] - y
        weight0 = bx * cy - by * cx
        weight1 = cx * ay - cy * ax
        weight2 = ax * by - ay * bx
    }

    private fun straightWalk(x: Double, y: Double, start: Int): Int {
        val startX = middle(start, 0)
        val startY = middle(start, 1)
        var t = start
        var entry = -1
        for (step in 0 until stepLimit) {
            weigh(t, x, y)
            reached = weight0 >= 0 && weight1 >= 0 && weight2 >= 0
            if (reached) return t
            val exit = exitOf(t, entry, startX, startY, x, y)
            if (exit < 0 || twins[exit] < 0) return t
            entry = twins[exit]
            t = entry / 3
        }
        return t
    }

    private fun middle(t: Int, axis: Int) =
        (xy[2 * nodes[3 * t] + axis] + xy[2 * nodes[3 * t + 1] + axis] + xy[2 * nodes[3 * t + 2] + axis]) / 3

    /** Side by which the ray from (sx, sy) to (x, y) leaves triangle [t], or -1. */
    private fun exitOf(t: Int, entry: Int, sx: Double, sy: Double, x: Double, y: Double): Int {
        val e = 3 * t
        var sideOfEnd = turn(sx, sy, x, y, nodes[e])
        val sideOfFirst = sideOfEnd
        for (k in 0..2) {
            val sideOfStart = sideOfEnd
            sideOfEnd = if (k == 2) sideOfFirst else turn(sx, sy, x, y, nodes[e + k + 1])
            if (e + k != entry && sideOfStart <= 0 && sideOfEnd >= 0 && (sideOfStart < 0 || sideOfEnd > 0)) return e + k
        }
        return -1
    }

    private fun turn(sx: Double, sy: Double, x: Double, y: Double, node: Int) =
        (x - sx) * (xy[2 * node + 1] - sy) - (y - sy) * (xy[2 * node] - sx)
}
