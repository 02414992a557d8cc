package org.trigrid.editor.canvas

/** Elements in the order of Morton's curve through their centroids: neighbours in the plane are neighbours in the order. */
internal object ElementOrder {
    private const val BITS = 16

    fun of(xy: DoubleArray, elements: IntArray): IntArray {
        var minX = Double.POSITIVE_INFINITY
        var minY = Double.POSITIVE_INFINITY
        var maxX = Double.NEGATIVE_INFINITY
        var maxY = Double.NEGATIVE_INFINITY
        for (i in xy.indices step 2) {
            minX = Math.min(minX, xy[i])
            maxX = Math.max(maxX, xy[i])
            minY = Math.min(minY, xy[i + 1])
            maxY = Math.max(maxY, xy[i + 1])
        }
        val scale = ((1 shl BITS) - 1) / Math.max(maxX - minX, maxY - minY).coerceAtLeast(java.lang.Double.MIN_NORMAL)
        val keys = LongArray(elements.size / 3) { t ->
            val a = 2 * elements[3 * t]
            val b = 2 * elements[3 * t + 1]
            val c = 2 * elements[3 * t + 2]
            val x = ((xy[a] + xy[b] + xy[c]) / 3 - minX) * scale
            val y = ((xy[a + 1] + xy[b + 1] + xy[c + 1]) / 3 - minY) * scale
            (spread(x.toLong()) or (spread(y.toLong()) shl 1) shl Int.SIZE_BITS - 1) or t.toLong()
        }
        keys.sort()
        return IntArray(keys.size) { (keys[it] and Int.MAX_VALUE.toLong()).toInt() }
    }

    /** The bits of [value], each with a zero before it. */
    private fun spread(value: Long): Long {
        var v = value and 0xFFFF
        v = (v or (v shl 8)) and 0x00FF00FF
        v = (v or (v shl 4)) and 0x0F0F0F0F
        v = (v or (v shl 2)) and 0x33333333
        return (v or (v shl 1)) and 0x55555555
    }
}
