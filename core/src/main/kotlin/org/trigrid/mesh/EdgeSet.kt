package org.trigrid.mesh

/** An immutable set of undirected edges between node numbers. */
internal class EdgeSet(
    /** 2 per edge; not modified. */
    pairs: IntArray,
) {
    private val keys: LongArray = LongArray(pairs.size / 2) { key(pairs[2 * it], pairs[2 * it + 1]) }.also { it.sort() }

    val size: Int get() = keys.size

    val isEmpty: Boolean get() = keys.isEmpty()

    fun contains(a: Int, b: Int): Boolean = keys.binarySearch(key(a, b)) >= 0

    private fun key(a: Int, b: Int): Long = (minOf(a, b).toLong() shl 32) or maxOf(a, b).toLong()

    companion object {
        val EMPTY: EdgeSet = EdgeSet(IntArray(0))
    }
}
