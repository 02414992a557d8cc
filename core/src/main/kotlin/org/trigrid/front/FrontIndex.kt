package org.trigrid.front

/**
 * Finds front edges near a place: a quadtree over the edges' midpoints.
 *
 * An edge lives in the smallest cell on the way to its midpoint whose side is at least [LOOSENESS] times the edge's
 * extent, so it may reach out of its cell. Long and short edges thus live on different levels, and the cost of a query
 * depends on what is near, not on how sizes vary over the domain. Each cell knows how far from its centre the edges in
 * and below it reach: far above short edges that is hardly more than the cell, and a query goes down one path, not four.
 * A cell is freed with its last edge: memory follows the front, not the mesh.
 */
internal class FrontIndex(minX: Double, minY: Double, maxX: Double, maxY: Double) {
    /** [LINKS] per cell: its four children, 0 for none; its parent; its first edge, -1 for none. */
    private var links = IntArray(LINKS * 64)

    /** [SHAPE] per cell: centre x and y, half of a child's side, nothing; then how far each child reaches. */
    private var shape = DoubleArray(SHAPE * 64)
    private var cells = 1
    private var freeCell = 0

    private var cellOf = IntArray(64)
    private var nextInCell = IntArray(64)
    private var previousInCell = IntArray(64)

    /** [BOX] per edge: least x and y, largest x and y. */
    private var boxes = DoubleArray(BOX * 64)

    /** Covers the rounding of midpoints, centres and distances, whatever the place of the domain. */
    private val slack: Double
    private var stack = IntArray(256)

    /** Edges found by the last [query]. */
    @JvmField var found = IntArray(64)

    @JvmField var foundCount = 0

    init {
        val side = Math.max(maxX - minX, maxY - minY)
        links[FIRST] = -1
        shape[0] = 0.5 * (minX + maxX)
        shape[1] = 0.5 * (minY + maxY)
        // A power of two, so that scaling a domain by one scales every cell and changes no comparison.
        shape[HALF] = Math.scalb(1.0, Math.getExponent(side))
        val farthest = Math.max(Math.max(Math.abs(minX), Math.abs(maxX)), Math.max(Math.abs(minY), Math.abs(maxY)))
        slack = Math.scalb(1.0, Math.getExponent(farthest) - SLACK_BITS)
    }

    fun insert(edge: Int, ax: Double, ay: Double, bx: Double, by: Double) {
        val cell = cellFor(0.5 * (ax + bx), 0.5 * (ay + by), 0.5 * Math.max(Math.abs(bx - ax), Math.abs(by - ay)))
        if (edge >= cellOf.size) growEdges(edge)
        val box = BOX * edge
        boxes[box] = Math.min(ax, bx)
        boxes[box + 1] = Math.min(ay, by)
        boxes[box + 2] = Math.max(ax, bx)
        boxes[box + 3] = Math.max(ay, by)
        val first = links[LINKS * cell + FIRST]
        cellOf[edge] = cell
        nextInCell[edge] = first
        previousInCell[edge] = -1
        if (first >= 0) previousInCell[first] = edge
        links[LINKS * cell + FIRST] = edge
    }

    /** The cell for an edge, made where there is none; those on the way learn how far an edge of this half extent reaches. */
    private fun cellFor(x: Double, y: Double, halfExtent: Double): Int {
        val wanted = LOOSENESS * halfExtent
        val own = halfExtent + slack
        var cell = 0
        while (true) {
            val at = SHAPE * cell
            val half = shape[at + HALF]
            if (half < wanted) return cell
            val dx = x - shape[at]
            val dy = y - shape[at + 1]
            val quadrant = (if (dx >= 0) 1 else 0) or (if (dy >= 0) 2 else 0)
            val reach = Math.max(Math.abs(Math.abs(dx) - half), Math.abs(Math.abs(dy) - half)) + own
            var below = links[LINKS * cell + quadrant]
            if (below == 0) {
                below = addCell(cell, quadrant)
                shape[SHAPE * cell + REACH + quadrant] = reach
            } else if (reach > shape[at + REACH + quadrant]) {
                shape[at + REACH + quadrant] = reach
            }
            cell = below
        }
    }

    fun remove(edge: Int) {
        var cell = cellOf[edge]
        val before = previousInCell[edge]
        val after = nextInCell[edge]
        if (after >= 0) previousInCell[after] = before
        if (before >= 0) {
            nextInCell[before] = after
            return
        }
        links[LINKS * cell + FIRST] = after
        while (cell != 0 && isEmpty(cell)) cell = release(cell)
    }

    /** Puts into [found] every edge whose own box overlaps this one. */
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
            collect(links[LINKS * cell + FIRST], x0, y0, x1, y1)
            if (depth + 4 > stack.size) stack = stack.copyOf(2 * stack.size)
            val at = SHAPE * cell
            val half = shape[at + HALF]
            val dx = x - shape[at]
            val dy = y - shape[at + 1]
            for (quadrant in 0..3) {
                val below = links[LINKS * cell + quadrant]
                if (below == 0) continue
                val reach = shape[at + REACH + quadrant]
                val fromX = if (quadrant and 1 != 0) dx - half else dx + half
                val fromY = if (quadrant and 2 != 0) dy - half else dy + half
                if (Math.abs(fromX) <= reach + halfWidth && Math.abs(fromY) <= reach + halfHeight) stack[depth++] = below
            }
        }
    }

    private fun collect(first: Int, x0: Double, y0: Double, x1: Double, y1: Double) {
        var edge = first
        while (edge >= 0) {
            val box = BOX * edge
            if (boxes[box] <= x1 && boxes[box + 2] >= x0 && boxes[box + 1] <= y1 && boxes[box + 3] >= y0) {
                if (foundCount == found.size) found = found.copyOf(2 * foundCount)
                found[foundCount++] = edge
            }
            edge = nextInCell[edge]
        }
    }

    private fun addCell(above: Int, quadrant: Int): Int {
        val cell: Int
        if (freeCell != 0) {
            cell = freeCell
            freeCell = links[LINKS * cell + PARENT]
        } else {
            cell = cells++
            if (LINKS * cell == links.size) growCells()
        }
        links[LINKS * above + quadrant] = cell
        links[LINKS * cell + PARENT] = above
        links[LINKS * cell + FIRST] = -1
        val half = shape[SHAPE * above + HALF]
        shape[SHAPE * cell] = shape[SHAPE * above] + (if (quadrant and 1 != 0) half else -half)
        shape[SHAPE * cell + 1] = shape[SHAPE * above + 1] + (if (quadrant and 2 != 0) half else -half)
        shape[SHAPE * cell + HALF] = 0.5 * half
        return cell
    }

    private fun isEmpty(cell: Int): Boolean {
        val at = LINKS * cell
        return links[at + FIRST] < 0 && links[at] or links[at + 1] or links[at + 2] or links[at + 3] == 0
    }

    /** Frees a cell and returns its parent. */
    private fun release(cell: Int): Int {
        val above = links[LINKS * cell + PARENT]
        for (at in LINKS * above..LINKS * above + 3) if (links[at] == cell) links[at] = 0
        links[LINKS * cell + PARENT] = freeCell
        freeCell = cell
        return above
    }

    private fun growCells() {
        links = links.copyOf(2 * links.size)
        shape = shape.copyOf(2 * shape.size)
    }

    private fun growEdges(edge: Int) {
        val size = Math.max(2 * cellOf.size, edge + 1)
        cellOf = cellOf.copyOf(size)
        nextInCell = nextInCell.copyOf(size)
        previousInCell = previousInCell.copyOf(size)
        boxes = boxes.copyOf(BOX * size)
    }

    private companion object {
        /** Of a cell's side to the extent of its edges, at least; lists are cheap to go through, levels are not. */
        const val LOOSENESS = 8.0

        /** 32 units in the last place. */
        const val SLACK_BITS = 47

        const val LINKS = 8
        const val PARENT = 4
        const val FIRST = 5
        const val SHAPE = 8
        const val HALF = 2
        const val REACH = 4
        const val BOX = 4
    }
}
