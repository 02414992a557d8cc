package org.trigrid.editor.canvas

import org.trigrid.editor.meshing.Colouring

/**
 * Colours for levels from 0 to 1 that colour-blind people can tell apart.
 *
 * @param ends upper ends of the classes but the last.
 * @param colours from the lowest class to the highest, 0xRRGGBB.
 */
internal class ColourScale private constructor(val ends: DoubleArray, val colours: IntArray) {
    /** 0xFFRRGGBB. */
    fun colour(level: Double): Int {
        var i = 0
        while (i < ends.size && level >= ends[i]) i++
        return OPAQUE or colours[i]
    }

    companion object {
        private const val OPAQUE = 0xFF shl 24

        /** From worst to best: ColorBrewer's RdYlBu (Harrower and Brewer 2003, Cartogr. J. 40:27-37). */
        private val RED_TO_BLUE = intArrayOf(
            0xA50026, 0xD73027, 0xF46D43, 0xFDAE61, 0xFEE090, 0xE0F3F8, 0xABD9E9, 0x74ADD1, 0x4575B4,
        )

        /** From small to large: viridis (Smith and van der Walt 2015), eight steps. */
        private val VIRIDIS = intArrayOf(0x440154, 0x46327E, 0x365C8D, 0x277F8E, 0x1FA187, 0x4AC16D, 0xA0DA39, 0xFDE725)

        private val QUALITY = ColourScale(doubleArrayOf(0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95), RED_TO_BLUE)

        /** Smallest angles of 10, 15, … 50 degrees as parts of 60. */
        private val ANGLE = ColourScale(DoubleArray(8) { (10 + 5.0 * it + if (it == 7) 5 else 0) / 60 }, RED_TO_BLUE)
        private val SIZE = ColourScale(DoubleArray(7) { (it + 1) / 8.0 }, VIRIDIS)
        private val DEGREE = ColourScale(
            doubleArrayOf(0.125, 0.375, 0.625, 0.875), intArrayOf(0xA50026, 0xF46D43, 0xFEE090, 0xABD9E9, 0x4575B4),
        )

        fun of(colouring: Colouring): ColourScale = when (colouring) {
            Colouring.NONE, Colouring.QUALITY -> QUALITY
            Colouring.MIN_ANGLE -> ANGLE
            Colouring.SIZE -> SIZE
            Colouring.DEGREE -> DEGREE
        }
    }
}
