package org.trigrid.geometry

/**
 * Steps around an element: its half-edges are 3 t, 3 t + 1 and 3 t + 2, anticlockwise.
 *
 * Sums instead of branches: which corner a walk comes by cannot be foreseen.
 */
internal object HalfEdges {
    /** The half-edge after [h] around its element. */
    @JvmStatic
    fun next(h: Int): Int = h + 1 - 3 * (h % 3 shr 1)

    /** The half-edge before [h] around its element. */
    @JvmStatic
    fun previous(h: Int): Int = h - 1 + 3 * (2 - h % 3 shr 1)
}
