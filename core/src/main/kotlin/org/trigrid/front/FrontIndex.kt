package org.trigrid.front

/**
 * Finds front edges near a place: a quadtree over the edges' midpoints that is entered at the height of the question.
 *
 * An edge lives in the cell round its midpoint, on the level whose side is [LOOSENESS] to twice as many times its extent, so
 * it may reach out of its cell by a known part of the side. Long and short edges thus live on different levels, and the cost
 * of a query depends on what is near, not on how sizes vary over the domain. A hash table knows the cells by level and
 * place: a query looks up the few cells of its own size and goes down from there; of the levels above it asks only
 * those that hold edges. A cell is freed with its last edge: memory follows the front, not the mesh.
 */
internal class FrontIndex(private val minX: Double, private val minY: Double, maxX: Double, maxY: Double) {
    private val cells = IndexCells()

    /** Cells of level k have the side 2 to the power of this, less k; the one of level 0 covers the domain. */
    private val rootExponent: Int
    private val deepest: Int
    private val sides: DoubleArray
    private val inverseSides: DoubleArray

    /** Per level: how far an edge reaches out of its cell, at most. */
    private val overhangs: DoubleArray
    private val edgesOnLevel: IntArray

    /** A bit for each level that holds edges. */
    private var occupied = 0

    private var cellOf = IntArray(64)
    private var nextInCell = IntArray(64)
    private var previousInCell = IntArray(64)

    /** [BOX] per edge: least x and y, largest x and y. */
    private var boxes = DoubleArray(BOX * 64)
    private var stack = IntArray(256)

    /** Edges found by the last [query]. */
    @JvmField var found = IntArray(64)

    @JvmField var foundCount = 0

    init {
        val side = Math.max(maxX - minX, maxY - minY)
        val farthest = Math.max(Math.max(Math.abs(minX), Math.abs(maxX)), Math.max(Math.abs(minY), Math.abs(maxY)))
        // Covers the rounding of midpoints and distances, whatever the place of the domain.
        val slackExponent = Math.max(Math.getExponent(farthest) - SLACK_BITS, java.lang.Double.MIN_EXPONENT)
        // Powers of two, so that scaling a domain by one scales every cell and changes no comparison.
        rootExponent = Math.getExponent(side) + 1
        deepest = Math.min(Math.max(rootExponent - slackExponent - 2, 0), IndexCells.LEVELS - 1)
        sides = DoubleArray(deepest + 1) { Math.scalb(1.0, rootExponent - it) }
        inverseSides = DoubleArray(deepest + 1) { Math.scalb(1.0, it - rootExponent) }
        val slack = Math.scalb(1.0, slackExponent)
        overhangs = DoubleArray(deepest + 1) { sides[it] / (2 * LOOSENESS) + slack }
        edgesOnLevel = IntArray(deepest + 1)
    }

    fun insert(edge: Int, ax: Double, ay: Double, bx: Double, by: Double) {
        if (edge >= cellOf.size) growEdges(edge)
        val box = BOX * edge
        boxes[box] = Math.min(ax, bx)
        boxes[box + 1] = Math.min(ay, by)
        boxes[box + 2] = Math.max(ax, bx)
        boxes[box + 3] = Math.max(ay, by)
        val extent = Math.max(Math.abs(bx - ax), Math.abs(by - ay))
        val level = levelOf(Math.getExponent(LOOSENESS * extent) + 1)
        val cell = cells.make(IndexCells.keyOf(level, place(0.5 * (ax + bx) - minX, level), place(0.5 * (ay + by) - minY, level)))
        val first = cells.firstEdge(cell)
        cellOf[edge] = cell
        nextInCell[edge] = first
        previousInCell[edge] = -1
        if (first >= 0) previousInCell[first] = edge
        cells.setFirstEdge(cell, edge)
        if (edgesOnLevel[level]++ == 0) occupied = occupied or (1 shl level)
    }

    /** The level of cells with a side of 2 to the power of [exponent], or the next one that there is. */
    private fun levelOf(exponent: Int): Int = Math.min(Math.max(rootExponent - exponent, 0), deepest)

    /** Number of the column or row of cells, clamped to those there are. */
    private fun place(offset: Double, level: Int): Long =
        Math.min(Math.max((offset * inverseSides[level]).toLong(), 0), (1L shl level) - 1)

    fun remove(edge: Int) {
        val cell = cellOf[edge]
        val level = IndexCells.level(cells.key(cell))
        if (--edgesOnLevel[level] == 0) occupied = occupied and (1 shl level).inv()
        val before = previousInCell[edge]
        val after = nextInCell[edge]
        if (after >= 0) previousInCell[after] = before
        if (before >= 0) {
            nextInCell[before] = after
            return
        }
        cells.setFirstEdge(cell, after)
        if (after < 0) cells.releaseEmpty(cell)
    }

    /** Puts into [found] every edge whose own box overlaps this one. */
    fun query(x0: Double, y0: Double, x1: Double, y1: Double) {
        foundCount = 0
        collect(IndexCells.ROOT, x0, y0, x1, y1)
        val entry = levelOf(Math.getExponent(Math.max(x1 - x0, y1 - y0)) + ENTRY)
        if (entry == 0) return descend(IndexCells.ROOT, x0, y0, x1, y1)
        val isLowest = occupied ushr entry + 1 == 0
        val last = if (isLowest) entry else entry - 1
        var levels = occupied and (1 shl last + 1) - 2
        while (levels != 0) {
            collectOn(Integer.numberOfTrailingZeros(levels), false, x0, y0, x1, y1)
            levels = levels and levels - 1
        }
        if (!isLowest) collectOn(entry, true, x0, y0, x1, y1)
    }

    /** Edges that live on a level and, if wanted, [below]. */
    private fun collectOn(level: Int, below: Boolean, x0: Double, y0: Double, x1: Double, y1: Double) {
        val overhang = overhangs[level]
        val lastColumn = place(x1 - minX + overhang, level)
        val firstRow = place(y0 - minY - overhang, level)
        val lastRow = place(y1 - minY + overhang, level)
        for (column in place(x0 - minX - overhang, level)..lastColumn) {
            var key = IndexCells.keyOf(level, column, firstRow)
            for (row in firstRow..lastRow) {
                val cell = cells.find(key++)
                if (cell < 0) continue
                collect(cell, x0, y0, x1, y1)
                if (below) descend(cell, x0, y0, x1, y1)
            }
        }
    }

    /** Edges that live below a cell. */
    private fun descend(top: Int, x0: Double, y0: Double, x1: Double, y1: Double) {
        if (!cells.hasChildren(top)) return
        stack[0] = top
        var depth = 1
        while (depth > 0) {
            val cell = stack[--depth]
            val level = IndexCells.level(cells.key(cell)) + 1
            val overhang = overhangs[level]
            val firstColumn = place(x0 - minX - overhang, level)
            val lastColumn = place(x1 - minX + overhang, level)
            val firstRow = place(y0 - minY - overhang, level)
            val lastRow = place(y1 - minY + overhang, level)
            if (depth + 4 > stack.size) stack = stack.copyOf(2 * stack.size)
            for (quadrant in 0..3) {
                val below = cells.child(cell, quadrant)
                if (below == 0) continue
                val column = IndexCells.column(cells.key(below))
                val row = IndexCells.row(cells.key(below))
                if (column < firstColumn || column > lastColumn || row < firstRow || row > lastRow) continue
                collect(below, x0, y0, x1, y1)
                if (cells.hasChildren(below)) stack[depth++] = below
            }
        }
    }

    /** Negative if the box of [edge] does not overlap this one, else not; in one number, for one branch or none. */
    fun apart(edge: Int, x0: Double, y0: Double, x1: Double, y1: Double): Long {
        val box = BOX * edge
        return bits(x1 - boxes[box]) or bits(boxes[box + 2] - x0) or bits(y1 - boxes[box + 1]) or bits(boxes[box + 3] - y0)
    }

    private fun collect(cell: Int, x0: Double, y0: Double, x1: Double, y1: Double) {
        val boxes = boxes
        val nextInCell = nextInCell
        var edge = cells.firstEdge(cell)
        var into = found
        var count = foundCount
        while (edge >= 0) {
            val box = BOX * edge
            // No branch, as none could be foreseen: any negative difference sets the sign.
            val apart = bits(x1 - boxes[box]) or bits(boxes[box + 2] - x0) or bits(y1 - boxes[box + 1]) or bits(boxes[box + 3] - y0)
            if (count == into.size) {
                into = into.copyOf(2 * count)
                found = into
            }
            into[count] = edge
            count += (apart.inv() ushr java.lang.Long.SIZE - 1).toInt()
            edge = nextInCell[edge]
        }
        foundCount = count
    }

    private fun bits(value: Double): Long = java.lang.Double.doubleToRawLongBits(value)

    private fun growEdges(edge: Int) {
        val size = Math.max(2 * cellOf.size, edge + 1)
        cellOf = cellOf.copyOf(size)
        nextInCell = nextInCell.copyOf(size)
        previousInCell = previousInCell.copyOf(size)
        boxes = boxes.copyOf(BOX * size)
    }

    private companion object {
        /** Of a cell's side to the extent of its edges, at least. */
        const val LOOSENESS = 8.0

        /** A query enters at cells of its own size, times 2 to the power of this. */
        const val ENTRY = 1

        /** 32 units in the last place. */
        const val SLACK_BITS = 47

        const val BOX = 4
    }
}
