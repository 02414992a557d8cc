package org.trigrid.geometry

import org.trigrid.diagnostics.Checkpoint

/**
 * The order in which points are best inserted into a triangulation one by one: random rounds, each about twice as
 * large as the one before, along a Hilbert curve within each round, so that successive points are near each other
 * while no input order is a bad one (Amenta, Choi and Rote 2003, Proc. 19th Symp. Comput. Geom., 211-219).
 *
 * The "random" choice is a fixed hash of the point's number, so the order depends on the input alone.
 */
internal object InsertionOrder {
    private const val BITS = 26
    private const val DIGIT_BITS = 13
    private const val SMALLEST_ROUND = 16

    /** @param xy x0, y0, x1, y1, …; finite; not modified. Returns a permutation of the point numbers. */
    @JvmStatic
    fun of(xy: DoubleArray, checkpoint: Checkpoint = Checkpoint.unheard()): IntArray = rounds(alongCurve(xy, checkpoint), checkpoint)

    /** Point numbers along a Hilbert curve (Hilbert 1891, Math. Ann. 38:459-460) over the square round all points. */
    @JvmStatic
    @JvmOverloads
    fun alongCurve(xy: DoubleArray, checkpoint: Checkpoint = Checkpoint.unheard()): IntArray =
        alongCurve(xy, checkpoint, xy.size / 2, BITS)

    /**
     * As the other; points of one cell of a grid of `2^bits` cells each way, [bits] being 13 or 26, keep their order.
     *
     * @param count of the points; there may be more in [xy].
     */
    @JvmStatic
    fun alongCurve(xy: DoubleArray, checkpoint: Checkpoint, count: Int, bits: Int): IntArray {
        var minX = Double.POSITIVE_INFINITY
        var minY = Double.POSITIVE_INFINITY
        var maxX = Double.NEGATIVE_INFINITY
        var maxY = Double.NEGATIVE_INFINITY
        for (i in 0 until count) {
            checkpoint.pass()
            minX = Math.min(minX, xy[2 * i])
            maxX = Math.max(maxX, xy[2 * i])
            minY = Math.min(minY, xy[2 * i + 1])
            maxY = Math.max(maxY, xy[2 * i + 1])
        }
        // Halves, as the whole extent of finite points may be beyond the range of doubles.
        val extent = Math.max(maxX / 2 - minX / 2, maxY / 2 - minY / 2)
        val scale = if (extent > 0) ((1 shl bits) - 1) / extent else 0.0
        val keys = LongArray(count) { i ->
            checkpoint.pass()
            curvePosition(((xy[2 * i] / 2 - minX / 2) * scale).toInt(), ((xy[2 * i + 1] / 2 - minY / 2) * scale).toInt(), bits)
        }
        return sortedByKey(keys, bits, checkpoint)
    }

    private fun curvePosition(cellX: Int, cellY: Int, bits: Int): Long {
        val mask = (1 shl bits) - 1
        var x = cellX
        var y = cellY
        var position = 0L
        for (bit in bits - 1 downTo 0) {
            val right = (x ushr bit) and 1
            val upper = (y ushr bit) and 1
            position = (position shl 2) or ((3 * right) xor upper).toLong()
            // Below, the axes are swapped, and on the right turned round before; masks, as branches could not be foreseen.
            val below = upper - 1
            val turned = mask and below and -right
            val swapped = (x xor y) and below
            x = x xor swapped xor turned
            y = y xor swapped xor turned
        }
        return position
    }

    /** Stable radix sort of the numbers 0..n-1 by their keys. */
    private fun sortedByKey(keys: LongArray, bits: Int, checkpoint: Checkpoint): IntArray {
        val digits = 1 shl DIGIT_BITS
        var order = IntArray(keys.size) { it }
        var spare = IntArray(keys.size)
        for (shift in 0 until 2 * bits step DIGIT_BITS) {
            val starts = IntArray(digits + 1)
            for (key in keys) {
                checkpoint.pass()
                starts[((key ushr shift) and (digits - 1L)).toInt() + 1]++
            }
            for (d in 0 until digits) starts[d + 1] += starts[d]
            for (i in order) {
                checkpoint.pass()
                spare[starts[((keys[i] ushr shift) and (digits - 1L)).toInt()]++] = i
            }
            val swap = order
            order = spare
            spare = swap
        }
        return order
    }

    private fun rounds(curve: IntArray, checkpoint: Checkpoint): IntArray {
        var last = 0
        while ((curve.size ushr (last + 1)) >= SMALLEST_ROUND) last++
        val starts = IntArray(last + 2)
        for (i in curve) {
            checkpoint.pass()
            starts[round(i, last) + 1]++
        }
        for (r in 0..last) starts[r + 1] += starts[r]
        val order = IntArray(curve.size)
        for (i in curve) {
            checkpoint.pass()
            order[starts[round(i, last)]++] = i
        }
        return order
    }

    /** Round 0 comes first; half of all points are in round [last], a quarter in the one before, … */
    private fun round(point: Int, last: Int): Int {
        var hash = point * -1640531527 + 0x5bd1e995
        hash = (hash xor (hash ushr 15)) * -2048144789
        hash = (hash xor (hash ushr 13)) * -1028477379
        return last - Math.min(last, Integer.numberOfTrailingZeros(hash xor (hash ushr 16)))
    }
}
