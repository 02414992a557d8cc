package org.trigrid.picture

/** Colours of pictures, 0xRRGGBB; all scales can be told apart by colour-blind readers. */
internal object Palette {
    const val PAPER = 0xFFFFFF
    const val INK = 0x1B2A38
    const val MUTED = 0x66788A
    const val MATERIAL = 0xEEF3F7
    const val MESH_LINE = 0x5B7186
    const val BOUNDARY = 0x14212E
    const val EMBEDDED = 0xC2571A
    const val NODE = 0x0B5C99
    const val FRAME = 0x9AA9B7
    const val BAND = 0xDCE9F3
    const val ENTRY = 0x14212E

    /** For groups that are told apart: Okabe and Ito's colours (2002), without yellow, which fails on white. */
    val groups = intArrayOf(0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x000000, 0x8B5A2B)

    /** For regions beside [MATERIAL]: tints of [groups], light enough for lines upon them. */
    val regions = intArrayOf(0xF5C9A6, 0xB5DCF2, 0xA9DDC9, 0xEBCBDD, 0xF7DC9C, 0xC3C9F0, 0xD9CDBF, 0xC9CFD6)

    /** Upper ends of the quality classes; an element on an end belongs to the class above. */
    val qualityEnds = doubleArrayOf(0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95)

    /** From worst to best: ColorBrewer's RdYlBu (Harrower and Brewer 2003, Cartogr. J. 40:27-37). */
    val qualityColours = intArrayOf(
        0xA50026, 0xD73027, 0xF46D43, 0xFDAE61, 0xFEE090, 0xE0F3F8, 0xABD9E9, 0x74ADD1, 0x4575B4,
    )

    fun qualityClass(q: Double): Int {
        var i = 0
        while (i < qualityEnds.size && q >= qualityEnds[i]) i++
        return i
    }
}
