package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.InsertionOrder
import org.trigrid.geometry.IntList

/**
 * Boxes of segments in a packed tree, to find the pairs and places that may touch.
 *
 * Segments are sorted along a Hilbert curve by the middles of their boxes; each tree node holds the box of [FANOUT]
 * successive nodes below it (Kamel & Faloutsos 1993, CIKM '93:490-499). Boxes are closed.
 */
internal class SegmentTree(
    private val xy: DoubleArray,
    /** 2 per segment: start node, end node, all finite. Not modified. */
    private val segments: IntArray,
    private val checkpoint: Checkpoint = Checkpoint.unheard(),
) {
    private val count = segments.size / 2

    /** Segment at each place of the lowest level. */
    private val order = hilbertOrder()

    /** First tree node of each level, the lowest first. */
    private val levelStarts: IntArray
    private val boxes: DoubleArray

    init {
        val starts = IntList()
        var start = 0
        var size = count
        while (true) {
            starts.add(start)
            start += size
            if (size <= 1) break
            size = (size + FANOUT - 1) / FANOUT
        }
        starts.add(start)
        levelStarts = starts.toArray()
        boxes = DoubleArray(4 * start)
        for (i in 0 until count) fillSegmentBox(i)
        checkpoint.ask()
        for (level in 1 until levelStarts.size - 1) {
            for (i in 0 until sizeOf(level)) fillNodeBox(level, i)
        }
    }

    /** Hears of segments that may touch; returns false to stop the search. */
    fun interface PairVisitor {
        fun visit(first: Int, second: Int): Boolean
    }

    /** Visits each pair of segments whose boxes touch once, the lower number first. */
    fun visitPairs(visitor: PairVisitor) {
        if (count > 1) join(levelStarts.size - 2, 0, 0, visitor)
    }

    /** Visits each segment whose box touches the box given. */
    inline fun forEachIn(minX: Double, minY: Double, maxX: Double, maxY: Double, action: (Int) -> Unit) {
        if (count == 0) return
        val stack = IntArray(STACK_SIZE)
        var depth = 0
        stack[depth++] = nodeCount() - 1
        while (depth > 0) {
            val node = stack[--depth]
            if (!touches(node, minX, minY, maxX, maxY)) continue
            if (isSegment(node)) {
                action(segmentAt(node))
            } else {
                for (child in firstChild(node)..lastChild(node)) stack[depth++] = child
            }
        }
    }

    fun nodeCount(): Int = boxes.size / 4

    fun isSegment(node: Int): Boolean = node < count

    fun segmentAt(node: Int): Int = order[node]

    fun touches(node: Int, minX: Double, minY: Double, maxX: Double, maxY: Double): Boolean =
        boxes[4 * node] <= maxX && boxes[4 * node + 2] >= minX && boxes[4 * node + 1] <= maxY && boxes[4 * node + 3] >= minY

    fun firstChild(node: Int): Int {
        val level = levelOf(node)
        return levelStarts[level - 1] + (node - levelStarts[level]) * FANOUT
    }

    fun lastChild(node: Int): Int = Math.min(firstChild(node) + FANOUT, levelStarts[levelOf(node)]) - 1

    private fun levelOf(node: Int): Int {
        var level = 1
        while (levelStarts[level + 1] <= node) level++
        return level
    }

    private fun join(level: Int, a: Int, b: Int, visitor: PairVisitor): Boolean {
        if (level == 0) {
            val s = order[a]
            val t = order[b]
            return if (s < t) visitor.visit(s, t) else visitor.visit(t, s)
        }
        val below = level - 1
        val end = sizeOf(below)
        for (i in a * FANOUT until Math.min(end, (a + 1) * FANOUT)) {
            val from = if (a != b) b * FANOUT else if (below == 0) i + 1 else i
            for (j in from until Math.min(end, (b + 1) * FANOUT)) {
                if (boxesTouch(levelStarts[below] + i, levelStarts[below] + j) && !join(below, i, j, visitor)) return false
            }
        }
        return true
    }

    private fun sizeOf(level: Int) = levelStarts[level + 1] - levelStarts[level]

    private fun boxesTouch(a: Int, b: Int) =
        touches(a, boxes[4 * b], boxes[4 * b + 1], boxes[4 * b + 2], boxes[4 * b + 3])

    private fun fillSegmentBox(i: Int) {
        checkpoint.pass()
        val a = segments[2 * order[i]]
        val b = segments[2 * order[i] + 1]
        boxes[4 * i] = Math.min(xy[2 * a], xy[2 * b])
        boxes[4 * i + 1] = Math.min(xy[2 * a + 1], xy[2 * b + 1])
        boxes[4 * i + 2] = Math.max(xy[2 * a], xy[2 * b])
        boxes[4 * i + 3] = Math.max(xy[2 * a + 1], xy[2 * b + 1])
    }

    private fun fillNodeBox(level: Int, i: Int) {
        val node = 4 * (levelStarts[level] + i)
        val first = levelStarts[level - 1] + i * FANOUT
        val last = Math.min(first + FANOUT, levelStarts[level]) - 1
        boxes.copyInto(boxes, node, 4 * first, 4 * first + 4)
        for (child in first + 1..last) {
            boxes[node] = Math.min(boxes[node], boxes[4 * child])
            boxes[node + 1] = Math.min(boxes[node + 1], boxes[4 * child + 1])
            boxes[node + 2] = Math.max(boxes[node + 2], boxes[4 * child + 2])
            boxes[node + 3] = Math.max(boxes[node + 3], boxes[4 * child + 3])
        }
    }

    private fun hilbertOrder(): IntArray {
        val middles = DoubleArray(2 * count)
        for (i in middles.indices) {
            checkpoint.pass()
            val segment = i and -2
            middles[i] = xy[2 * segments[segment] + (i and 1)] / 2 + xy[2 * segments[segment + 1] + (i and 1)] / 2
        }
        return InsertionOrder.alongCurve(middles, checkpoint)
    }

    companion object {
        private const val FANOUT = 8

        /** Room for the unvisited siblings on every level of the largest possible tree. */
        const val STACK_SIZE = 11 * FANOUT + 1
    }
}
