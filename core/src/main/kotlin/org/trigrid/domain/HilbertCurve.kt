package org.trigrid.domain

/** The place of a cell of a square grid along the Hilbert curve (Hilbert 1891). */
internal object HilbertCurve {
    private const val LEVELS = 15

    /** Cells along a side of the grid. */
    const val SIDE: Int = 1 shl LEVELS

    /** @return 0 until SIDE²; neighbours along the curve share a side. */
    fun key(column: Int, row: Int): Long {
        var x = column
        var y = row
        var key = 0L
        for (level in LEVELS - 1 downTo 0) {
            val right = (x shr level) and 1
            val upper = (y shr level) and 1
            key = (key shl 2) or ((3 * right) xor upper).toLong()
            val mask = (1 shl level) - 1
            x = x and mask
            y = y and mask
            if (upper == 0) {
                if (right == 1) {
                    x = mask - x
                    y = mask - y
                }
                val swapped = x
                x = y
                y = swapped
            }
        }
        return key
    }
}
