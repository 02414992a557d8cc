package org.trigrid.front

/**
 * Finds front edges near a place: a loose quadtree over the edges' midpoints.
 *
 * An edge lives in the smallest cell on the way to its midpoint whose side is at least [LOOSENESS] times the edge's
 * extent, so it reaches out of its cell by at most `side / (2 LOOSENESS)`. Long and short edges thus live on
 * different levels, and the cost of a query depends on what is near, not on how sizes vary over the domain. A cell is
 * freed with its last edge: memory follows the front, not the mesh.
 */
internal class FrontIndex(minX: Double, minY: Double, maxX: Double, maxY: Double) {
    private var child = IntArray(4 * 64)
    private var parent = IntArray(64)
    private var count = IntArray(64)
    private var head = IntArray(64)

    /** Centre x, centre y and half of the loose side, 3 per cell. */
    private var box = DoubleArray(3 * 64)
    private var cells = 1
    private var freeCell = 0
    private val rootHalf: Double

    /** What rounding may do to midpoints and to centres of cells, which cells far smaller than their coordinates do not cover. */
    private val slack: Double

    private var cellOf = IntArray(64)
    private var nextInCell = IntArray(64)
    private var previousInCell = IntArray(64)
    private var stack = IntArray(256)

    /** Edges found by the last [query]. */
    @JvmField var found = IntArray(64)

    @JvmField var foundCount = 0

    init {
        val side = Math.max(maxX - minX, maxY - minY)
        // A power of two, so that scaling a domain by one scales every cell and changes no comparison.
        rootHalf = Math.scalb(1.0, Math.getExponent(side) + 1)
        slack = ROUNDED_STEPS * Math.max(ulpOf(minX, maxX), ulpOf(minY, maxY))
        head[0] = -1
        box[0] = 0.5 * (minX + maxX)
        box[1] = 0.5 * (minY + maxY)
        box[2] = Double.POSITIVE_INFINITY
    }

    fun insert(edge: Int, ax: Double, ay: Double, bx: Double, by: Double) {
        val x = 0.5 * (ax + bx)
        val y = 0.5 * (ay + by)
        val wanted = LOOSENESS * Math.max(Math.abs(bx - ax), Math.abs(by - ay))
        var cell = 0
        var half = rootHalf
        count[0]++
        while (half >= wanted) {
            val quadrant = (if (x >= box[3 * cell]) 1 else 0) or (if (y >= box[3 * cell + 1]) 2 else 0)
            half *= 0.5
            var below = child[4 * cell + quadrant]
            if (below == 0) below = addCell(cell, quadrant, half)
            cell = below
            count[cell]++
        }
        if (edge >= cellOf.size) growEdges(edge)
        val first = head[cell]
        cellOf[edge] = cell
        nextInCell[edge] = first
        previousInCell[edge] = -1
        if (first >= 0) previousInCell[first] = edge
        head[cell] = edge
    }

    fun remove(edge: Int) {
        var cell = cellOf[edge]
        val before = previousInCell[edge]
        val after = nextInCell[edge]
        if (before >= 0) nextInCell[before] = after else head[cell] = after
        if (after >= 0) previousInCell[after] = before
        while (cell != 0) {
            val above = parent[cell]
            if (--count[cell] == 0) release(cell, above)
            cell = above
        }
        count[0]--
    }

    /** Puts into [found] every edge whose loose cell overlaps the box; the edges' own boxes are the caller's to test. */
    fun query(x0: Double, y0: Double, x1: Double, y1: Double) {
        val x = 0.5 * (x0 + x1)
        val y = 0.5 * (y0 + y1)
        val halfWidth = 0.5 * (x1 - x0)
        val halfHeight = 0.5 * (y1 - y0)
        foundCount = 0
        stack[0] = 0
        var depth = 1
        while (depth > 0) {
            val cell = stack[--depth]
            var edge = head[cell]
            while (edge >= 0) {
                if (foundCount == found.size) found = found.copyOf(2 * foundCount)
                found[foundCount++] = edge
                edge = nextInCell[edge]
            }
            if (depth + 4 > stack.size) stack = stack.copyOf(2 * stack.size)
            for (at in 4 * cell..4 * cell + 3) {
                val below = child[at]
                if (below == 0) continue
                val reach = box[3 * below + 2]
                if (Math.abs(box[3 * below] - x) <= reach + halfWidth && Math.abs(box[3 * below + 1] - y) <= reach + halfHeight) {
                    stack[depth++] = below
                }
            }
        }
    }

    private fun addCell(above: Int, quadrant: Int, half: Double): Int {
        val cell: Int
        if (freeCell != 0) {
            cell = freeCell
            freeCell = parent[cell]
        } else {
            cell = cells++
            if (cell == parent.size) growCells()
        }
        child[4 * above + quadrant] = cell
        child.fill(0, 4 * cell, 4 * cell + 4)
        parent[cell] = above
        count[cell] = 0
        head[cell] = -1
        box[3 * cell] = box[3 * above] + (if (quadrant and 1 != 0) half else -half)
        box[3 * cell + 1] = box[3 * above + 1] + (if (quadrant and 2 != 0) half else -half)
        box[3 * cell + 2] = half * (1 + 1 / LOOSENESS) * ROUNDING + slack
        return cell
    }

    private fun release(cell: Int, above: Int) {
        for (at in 4 * above..4 * above + 3) if (child[at] == cell) child[at] = 0
        parent[cell] = freeCell
        freeCell = cell
    }

    private fun ulpOf(low: Double, high: Double) = Math.ulp(Math.max(Math.abs(low), Math.abs(high)))

    private fun growCells() {
        val size = 2 * parent.size
        child = child.copyOf(4 * size)
        parent = parent.copyOf(size)
        count = count.copyOf(size)
        head = head.copyOf(size)
        box = box.copyOf(3 * size)
    }

    private fun growEdges(edge: Int) {
        val size = Math.max(2 * cellOf.size, edge + 1)
        cellOf = cellOf.copyOf(size)
        nextInCell = nextInCell.copyOf(size)
        previousInCell = previousInCell.copyOf(size)
    }

    private companion object {
        const val LOOSENESS = 1.0

        /** Covers the rounding of what is relative to a cell. */
        const val ROUNDING = 1.0 + 1e-9

        /** Units in the last place by which a midpoint and a centre may be off together, with room to spare. */
        const val ROUNDED_STEPS = 4.0
    }
}
