package org.trigrid.front

/** The cells of a quadtree, each known by a key of its level and place, found from above and by hash. */
internal class IndexCells {
    /** [LINKS] per cell: its four children, 0 for none; its parent; its first edge, -1 for none; the next one of its hash. */
    private var links = IntArray(LINKS * CAPACITY)
    private var keys = LongArray(CAPACITY)
    private var count = 1
    private var free = 0

    /** First cell of each hash, -1 for none. A power of two of them. */
    private var heads = IntArray(2 * CAPACITY).apply { fill(-1) }
    private var shift = java.lang.Long.numberOfLeadingZeros(heads.size.toLong()) + 1

    init {
        links[FIRST] = -1
        chain(ROOT)
    }

    /** Child cell, or 0. */
    fun child(cell: Int, quadrant: Int): Int = links[LINKS * cell + quadrant]

    fun hasChildren(cell: Int): Boolean {
        val at = LINKS * cell
        return links[at] or links[at + 1] or links[at + 2] or links[at + 3] != 0
    }

    fun key(cell: Int): Long = keys[cell]

    fun firstEdge(cell: Int): Int = links[LINKS * cell + FIRST]

    fun setFirstEdge(cell: Int, edge: Int) {
        links[LINKS * cell + FIRST] = edge
    }

    /** The cell of a key, or -1. */
    fun find(key: Long): Int {
        var cell = heads[hash(key)]
        while (cell >= 0 && keys[cell] != key) cell = links[LINKS * cell + CHAIN]
        return cell
    }

    /** The cell of a key; made, and those above it, where there is none. */
    fun make(key: Long): Int {
        val known = find(key)
        if (known >= 0) return known
        val above = make(keyAbove(key))
        val cell = if (free != 0) free else count++
        if (free != 0) free = links[LINKS * cell + CHAIN]
        if (cell == keys.size) grow()
        val at = LINKS * cell
        java.util.Arrays.fill(links, at, at + 4, 0)
        links[at + PARENT] = above
        links[at + FIRST] = -1
        keys[cell] = key
        chain(cell)
        links[LINKS * above + quadrant(key)] = cell
        return cell
    }

    /** Frees a cell without edges and children, and those above it that are left without any. */
    fun releaseEmpty(cell: Int) {
        var empty = cell
        while (empty != ROOT && firstEdge(empty) < 0 && !hasChildren(empty)) {
            val above = links[LINKS * empty + PARENT]
            links[LINKS * above + quadrant(keys[empty])] = 0
            unchain(empty)
            keys[empty] = NO_KEY
            links[LINKS * empty + CHAIN] = free
            free = empty
            empty = above
        }
    }

    private fun chain(cell: Int) {
        val hash = hash(keys[cell])
        links[LINKS * cell + CHAIN] = heads[hash]
        heads[hash] = cell
    }

    private fun unchain(cell: Int) {
        val hash = hash(keys[cell])
        val after = links[LINKS * cell + CHAIN]
        if (heads[hash] == cell) {
            heads[hash] = after
            return
        }
        var before = heads[hash]
        while (links[LINKS * before + CHAIN] != cell) before = links[LINKS * before + CHAIN]
        links[LINKS * before + CHAIN] = after
    }

    private fun hash(key: Long): Int = (key * SPREAD ushr shift).toInt()

    private fun grow() {
        val size = 2 * keys.size
        links = links.copyOf(LINKS * size)
        keys = keys.copyOf(size)
        heads = IntArray(2 * size)
        heads.fill(-1)
        shift--
        for (cell in 0 until size / 2) if (keys[cell] != NO_KEY) chain(cell)
    }

    companion object {
        const val ROOT: Int = 0

        /** Levels below this have keys. */
        const val LEVELS: Int = 30
        private const val BITS = 29
        private const val MASK = (1L shl BITS) - 1
        private const val NO_KEY = -1L
        private const val CAPACITY = 64
        private const val LINKS = 8
        private const val PARENT = 4
        private const val FIRST = 5
        private const val CHAIN = 6

        /** 2 to the power of 64 over the golden ratio. */
        private const val SPREAD = -0x61c8864680b583ebL

        /** Key of the cell in a column and a row of its level; the next row's is the next number. */
        @JvmStatic
        fun keyOf(level: Int, column: Long, row: Long): Long = ((level.toLong() shl BITS) + column shl BITS) + row

        @JvmStatic
        fun level(key: Long): Int = (key ushr 2 * BITS).toInt()

        @JvmStatic
        fun column(key: Long): Long = key ushr BITS and MASK

        @JvmStatic
        fun row(key: Long): Long = key and MASK

        private fun keyAbove(key: Long): Long = keyOf(level(key) - 1, column(key) shr 1, row(key) shr 1)

        private fun quadrant(key: Long): Int = (column(key).toInt() and 1) or (row(key).toInt() and 1 shl 1)
    }
}
