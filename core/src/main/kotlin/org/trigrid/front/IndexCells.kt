package org.trigrid.front

/** The cells of a quadtree, each with its place on its level, found from above and by a hash of level and place. */
internal class IndexCells {
    /** [LINKS] per cell: its four children, 0 for none; its parent; its first edge, -1 for none; the next one of its hash; its level. */
    private var links = IntArray(LINKS * CAPACITY)
    private var columns = LongArray(CAPACITY)
    private var rows = LongArray(CAPACITY)
    private var count = 1
    private var free = 0

    /** First cell of each hash, -1 for none. */
    private var heads = IntArray(2 * CAPACITY).apply { fill(-1) }

    init {
        links[FIRST] = -1
        links[CHAIN] = -1
        heads[hash(0, 0, 0)] = ROOT
    }

    fun level(cell: Int): Int = links[LINKS * cell + LEVEL]

    fun column(cell: Int): Long = columns[cell]

    fun row(cell: Int): Long = rows[cell]

    /** Child cell, or 0. */
    fun child(cell: Int, quadrant: Int): Int = links[LINKS * cell + quadrant]

    fun hasChildren(cell: Int): Boolean {
        val at = LINKS * cell
        return links[at] or links[at + 1] or links[at + 2] or links[at + 3] != 0
    }

    fun firstEdge(cell: Int): Int = links[LINKS * cell + FIRST]

    fun setFirstEdge(cell: Int, edge: Int) {
        links[LINKS * cell + FIRST] = edge
    }

    /** The cell at a place, or -1. */
    fun find(level: Int, column: Long, row: Long): Int {
        var cell = heads[hash(level, column, row)]
        while (cell >= 0 && (columns[cell] != column || rows[cell] != row || links[LINKS * cell + LEVEL] != level)) {
            cell = links[LINKS * cell + CHAIN]
        }
        return cell
    }

    /** The cell at a place; made, and those above it, where there is none. */
    fun make(level: Int, column: Long, row: Long): Int {
        val known = find(level, column, row)
        if (known >= 0) return known
        val above = make(level - 1, column shr 1, row shr 1)
        val cell = if (free != 0) free else count++
        if (free != 0) free = links[LINKS * cell + CHAIN]
        if (cell == columns.size) grow()
        val at = LINKS * cell
        java.util.Arrays.fill(links, at, at + 4, 0)
        links[at + PARENT] = above
        links[at + FIRST] = -1
        links[at + LEVEL] = level
        columns[cell] = column
        rows[cell] = row
        chain(cell)
        links[LINKS * above + quadrant(cell)] = cell
        return cell
    }

    /** Frees a cell without edges and children, and those above it that are left without any. */
    fun releaseEmpty(cell: Int) {
        var empty = cell
        while (empty != ROOT && firstEdge(empty) < 0 && !hasChildren(empty)) {
            val above = links[LINKS * empty + PARENT]
            links[LINKS * above + quadrant(empty)] = 0
            unchain(empty)
            links[LINKS * empty + CHAIN] = free
            free = empty
            empty = above
        }
    }

    private fun quadrant(cell: Int): Int = (columns[cell].toInt() and 1) or (rows[cell].toInt() and 1 shl 1)

    private fun chain(cell: Int) {
        val hash = hash(level(cell), columns[cell], rows[cell])
        links[LINKS * cell + CHAIN] = heads[hash]
        heads[hash] = cell
    }

    private fun unchain(cell: Int) {
        val hash = hash(level(cell), columns[cell], rows[cell])
        val after = links[LINKS * cell + CHAIN]
        if (heads[hash] == cell) {
            heads[hash] = after
            return
        }
        var before = heads[hash]
        while (links[LINKS * before + CHAIN] != cell) before = links[LINKS * before + CHAIN]
        links[LINKS * before + CHAIN] = after
    }

    private fun hash(level: Int, column: Long, row: Long): Int {
        val mixed = (column * COLUMN + row) * ROW + level * LEVELS
        return (mixed xor (mixed ushr 32)).toInt() and heads.size - 1
    }

    private fun grow() {
        val size = 2 * columns.size
        links = links.copyOf(LINKS * size)
        columns = columns.copyOf(size)
        rows = rows.copyOf(size)
        heads = IntArray(2 * size)
        heads.fill(-1)
        var cell = free
        while (cell != 0) {
            val next = links[LINKS * cell + CHAIN]
            links[LINKS * cell + LEVEL] = -1
            cell = next
        }
        for (live in 0 until size / 2) if (links[LINKS * live + LEVEL] >= 0) chain(live)
    }

    companion object {
        const val ROOT: Int = 0
        private const val CAPACITY = 64
        private const val LINKS = 8
        private const val PARENT = 4
        private const val FIRST = 5
        private const val CHAIN = 6
        private const val LEVEL = 7

        /** Odd numbers that spread places over the table. */
        private const val COLUMN = 0x5851F42D4C957F2DL
        private const val ROW = -0x61c8864680b583ebL
        private const val LEVELS = 0x2545F4914F6CDD1DL
    }
}
