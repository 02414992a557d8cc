package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException

/** What a drawing or a block of it consists of. */
internal sealed interface DxfItem

internal class DxfCurve(val curve: MappableCurve, val layer: String) : DxfItem

/** An entity that cannot be read, which matters only where its block is used. */
internal class DxfRefusal(val reason: FileFormatException) : DxfItem

/** A block put into the drawing, or into another block, once or in rows and columns. */
internal class DxfInsert(
    val block: String,
    val layer: String,
    /** From the block's coordinates, its base point at the origin. */
    val maps: List<AffineMap>,
    val line: Int,
) : DxfItem

/** A block: the items between BLOCK and ENDBLK, whose base point goes to where it is inserted. */
internal class DxfBlock(val baseX: Double, val baseY: Double) {
    val items = ArrayList<DxfItem>()
}

/** Puts the pieces of blocks where they are inserted. */
internal class DxfBlocks(private val blocks: Map<String, DxfBlock>, private val pairs: DxfPairs) {
    private val pieces = ArrayList<OutlinePiece>()

    /** The pieces of [items] by [map]. */
    fun pieces(items: List<DxfItem>, map: AffineMap): List<OutlinePiece> {
        place(items, map, null, emptyList())
        return pieces
    }

    /** @param layer of what is drawn on layer 0 of a block, which is on that of the block. */
    private fun place(items: List<DxfItem>, map: AffineMap, layer: String?, within: List<String>) {
        for (item in items) {
            when (item) {
                is DxfCurve -> {
                    val curve = if (map === AffineMap.IDENTITY) item.curve else item.curve.mapped(map)
                    pieces.add(OutlinePiece(curve, own(item.layer, layer)))
                    if (pieces.size > MOST_PIECES) pairs.fail("the blocks put more than $MOST_PIECES pieces into the drawing")
                }
                is DxfInsert -> place(item, map, layer, within)
                is DxfRefusal -> throw item.reason
            }
        }
    }

    private fun place(insert: DxfInsert, map: AffineMap, layer: String?, within: List<String>) {
        val block = blocks[insert.block] ?: pairs.failAtLine(insert.line, "there is no block ${insert.block}")
        if (insert.block in within) pairs.failAtLine(insert.line, "the block ${insert.block} is inserted in itself")
        val toOrigin = AffineMap.translation(-block.baseX, -block.baseY)
        for (own in insert.maps) place(block.items, map * own * toOrigin, own(insert.layer, layer), within + insert.block)
    }

    private fun own(layer: String, outer: String?): String = if (layer == "0" && outer != null) outer else layer

    private companion object {
        /** More would make much of a small file. */
        const val MOST_PIECES = 1_000_000
    }
}
