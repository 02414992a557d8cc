package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.InsertionOrder
import org.trigrid.geometry.IntList

/**
 * Lower envelope of cones: `min over sources i of (h_i + g |x - x_i|)`, the largest function with slope at most g that
 * is nowhere above its sources.
 *
 * A kd-tree whose nodes keep their box and the smallest h in it; a branch is left when even `h + g * distance of the box`
 * cannot win. All arrays are flat and an evaluation allocates nothing. Any h may be used, negative ones too.
 *
 * @param xy x0, y0, x1, y1, … of the sources; not kept.
 * @param sizes h of each source; infinity for one that never wins; not kept.
 */
internal class ConeTree(
    xy: DoubleArray,
    sizes: DoubleArray,
    private val slope: Double,
    private val checkpoint: Checkpoint = Checkpoint.unheard(),
) {
    private val count = sizes.size

    /** How many sources there are. */
    val sourceCount: Int get() = count
    private val order = InsertionOrder.alongCurve(xy, checkpoint)
    private val place = IntArray(count)
    private val sourceX = DoubleArray(count)
    private val sourceY = DoubleArray(count)
    private val sourceSize = DoubleArray(count)

    /** The first tree node that is a leaf; leaves hold [LEAF] sources each, in their order along the curve. */
    private val firstLeaf: Int

    /** Per tree node: min x, min y, max x, max y, min size. */
    private val box: DoubleArray
    private val leafStart: IntArray
    private val pending = IntArray(64)

    /** Of each waiting tree node: what it can offer at best. */
    private val pendingOffer = DoubleArray(64)

    /** Index (in the arrays given) of the source that won the last evaluation; -1 when there was none. */
    var winner = -1
        private set

    init {
        var leaves = 1
        while (leaves.toLong() * LEAF < count) leaves *= 2
        firstLeaf = leaves - 1
        leafStart = IntArray(leaves + 1) { (it.toLong() * count / leaves).toInt() }
        arrange(xy)
        for (i in 0 until count) {
            checkpoint.pass()
            val source = order[i]
            place[source] = i
            sourceX[i] = xy[2 * source]
            sourceY[i] = xy[2 * source + 1]
            sourceSize[i] = sizes[source]
        }
        box = DoubleArray(5 * (2 * leaves - 1))
        for (node in 2 * leaves - 2 downTo 0) if (node >= firstLeaf) boxLeaf(node) else boxInner(node)
    }

    /** Sorts [order] so that each leaf's share is a compact patch: halves by count across the longer side of their box. */
    private fun arrange(xy: DoubleArray) {
        val ranges = IntList()
        addRange(ranges, 0, count, 0)
        while (ranges.size > 0) {
            val node = ranges.removeLast()
            val to = ranges.removeLast()
            val from = ranges.removeLast()
            if (node >= firstLeaf) continue
            val middle = startOf(2 * node + 2)
            if (middle > from && middle < to) selectMiddle(xy, from, to, middle)
            addRange(ranges, from, middle, 2 * node + 1)
            addRange(ranges, middle, to, 2 * node + 2)
        }
    }

    private fun addRange(ranges: IntList, start: Int, end: Int, node: Int) {
        ranges.add(start)
        ranges.add(end)
        ranges.add(node)
    }

    /** First place in the leaf order of the sources below a tree node. */
    private fun startOf(node: Int): Int {
        var leaf = node
        while (leaf < firstLeaf) leaf = 2 * leaf + 1
        return leafStart[leaf - firstLeaf]
    }

    /** Quickselect along the longer side of the box of the sources [start] until [end]; ties by number. */
    private fun selectMiddle(xy: DoubleArray, start: Int, end: Int, middle: Int) {
        val axis = longerAxis(xy, start, end)
        var low = start
        var high = end - 1
        while (low < high) {
            if (high - low > LONG_RANGE) checkpoint.ask() else checkpoint.pass()
            val pivot = order[medianOfThree(xy, axis, low, high)]
            var i = low
            var j = high
            while (i <= j) {
                while (isBefore(xy, axis, order[i], pivot)) i++
                while (isBefore(xy, axis, pivot, order[j])) j--
                if (i <= j) {
                    val swap = order[i]
                    order[i++] = order[j]
                    order[j--] = swap
                }
            }
            if (middle <= j) high = j else if (middle >= i) low = i else return
        }
    }

    private fun medianOfThree(xy: DoubleArray, axis: Int, low: Int, high: Int): Int {
        val middle = (low + high) ushr 1
        val ab = isBefore(xy, axis, order[low], order[middle])
        val bc = isBefore(xy, axis, order[middle], order[high])
        if (ab == bc) return middle
        val ac = isBefore(xy, axis, order[low], order[high])
        return if (ab == ac) high else low
    }

    private fun isBefore(xy: DoubleArray, axis: Int, a: Int, b: Int): Boolean {
        val x = xy[2 * a + axis]
        val y = xy[2 * b + axis]
        return x < y || (x == y && a < b)
    }

    private fun longerAxis(xy: DoubleArray, start: Int, end: Int): Int {
        var minX = Double.POSITIVE_INFINITY
        var minY = Double.POSITIVE_INFINITY
        var maxX = Double.NEGATIVE_INFINITY
        var maxY = Double.NEGATIVE_INFINITY
        for (k in start until end) {
            val x = xy[2 * order[k]]
            val y = xy[2 * order[k] + 1]
            minX = Math.min(minX, x)
            maxX = Math.max(maxX, x)
            minY = Math.min(minY, y)
            maxY = Math.max(maxY, y)
        }
        return if (maxX - minX >= maxY - minY) 0 else 1
    }

    private fun boxLeaf(node: Int) {
        val b = 5 * node
        emptyBox(b)
        for (i in leafStart[node - firstLeaf] until leafStart[node - firstLeaf + 1]) {
            box[b] = Math.min(box[b], sourceX[i])
            box[b + 1] = Math.min(box[b + 1], sourceY[i])
            box[b + 2] = Math.max(box[b + 2], sourceX[i])
            box[b + 3] = Math.max(box[b + 3], sourceY[i])
            box[b + 4] = Math.min(box[b + 4], sourceSize[i])
        }
    }

    private fun emptyBox(b: Int) {
        box.fill(Double.POSITIVE_INFINITY, b, b + 2)
        box.fill(Double.NEGATIVE_INFINITY, b + 2, b + 4)
        box[b + 4] = Double.POSITIVE_INFINITY
    }

    private fun boxInner(node: Int) {
        val b = 5 * node
        val left = 5 * (2 * node + 1)
        val right = left + 5
        box[b] = Math.min(box[left], box[right])
        box[b + 1] = Math.min(box[left + 1], box[right + 1])
        box[b + 2] = Math.max(box[left + 2], box[right + 2])
        box[b + 3] = Math.max(box[left + 3], box[right + 3])
        box[b + 4] = Math.min(box[left + 4], box[right + 4])
    }

    /** The cone of one source at a place. */
    fun coneOf(source: Int, x: Double, y: Double): Double {
        val i = place[source]
        return sourceSize[i] + slope * distance(x - sourceX[i], y - sourceY[i])
    }

    /**
     * The envelope at ([x], [y]), or [bound] where that is smaller ([winner] is then -1).
     *
     * @param hint a source that is likely to win, or -1.
     * @param tolerance how far, as a share of it, the answer may lie above the envelope; 0 where sizes may be negative. Near the
     *   middle of a round domain all sources are all but equally near, and an exact answer would look at most of them.
     */
    fun min(x: Double, y: Double, hint: Int, bound: Double, tolerance: Double): Double {
        val goodEnough = 1 - tolerance
        var best = bound
        winner = -1
        if (hint >= 0) {
            val first = coneOf(hint, x, y)
            if (first < best) {
                best = first
                winner = hint
            }
        }
        var size = 0
        var node = 0
        var offer = offerOf(0, x, y)
        while (true) {
            if (offer < best * goodEnough) {
                if (node < firstLeaf) {
                    val left = 2 * node + 1
                    val ofLeft = offerOf(left, x, y)
                    val ofRight = offerOf(left + 1, x, y)
                    val isLeftFirst = ofLeft <= ofRight
                    pending[size] = if (isLeftFirst) left + 1 else left
                    pendingOffer[size++] = if (isLeftFirst) ofRight else ofLeft
                    node = if (isLeftFirst) left else left + 1
                    offer = if (isLeftFirst) ofLeft else ofRight
                    continue
                }
                best = bestOfLeaf(node, x, y, best)
            }
            if (size == 0) return best
            node = pending[--size]
            offer = pendingOffer[size]
        }
    }

    /** As above, exact. */
    fun min(x: Double, y: Double, hint: Int, bound: Double): Double = min(x, y, hint, bound, 0.0)

    private fun bestOfLeaf(node: Int, x: Double, y: Double, bound: Double): Double {
        var best = bound
        for (i in leafStart[node - firstLeaf] until leafStart[node - firstLeaf + 1]) {
            val cone = sourceSize[i] + slope * distance(x - sourceX[i], y - sourceY[i])
            if (cone < best) {
                best = cone
                winner = order[i]
            }
        }
        return best
    }

    /** The least that a source below the tree node can give. */
    private fun offerOf(node: Int, x: Double, y: Double) = box[5 * node + 4] + slope * Math.sqrt(squaredDistance(node, x, y))

    private fun squaredDistance(node: Int, x: Double, y: Double): Double {
        val b = 5 * node
        val dx = Math.max(0.0, Math.max(box[b] - x, x - box[b + 2]))
        val dy = Math.max(0.0, Math.max(box[b + 1] - y, y - box[b + 3]))
        return dx * dx + dy * dy
    }

    private fun distance(dx: Double, dy: Double) = Math.sqrt(dx * dx + dy * dy)

    private companion object {
        const val LEAF = 8

        /** Sources whose sorting takes a millisecond or so. */
        const val LONG_RANGE = 50_000
    }
}
