package org.trigrid.io

/** Finds nodes by their ids: by a table where ids are dense, else by search in the sorted ids. */
internal class NodeIndex(ids: IntArray) {
    private val table: IntArray?
    private val sorted: LongArray

    /** An id that occurs twice, or -1. */
    val duplicate: Int

    init {
        val highest = ids.maxOrNull() ?: 0
        var twice = -1
        if (highest <= 4L * ids.size + 1000) {
            val nodes = IntArray(highest + 1) { -1 }
            for (node in ids.indices) {
                if (nodes[ids[node]] >= 0) twice = ids[node]
                nodes[ids[node]] = node
            }
            table = nodes
            sorted = LongArray(0)
        } else {
            table = null
            sorted = LongArray(ids.size) { (ids[it].toLong() shl 32) or it.toLong() }
            sorted.sort()
            for (i in 1 until sorted.size) if (sorted[i] ushr 32 == sorted[i - 1] ushr 32) twice = (sorted[i] ushr 32).toInt()
        }
        duplicate = twice
    }

    /** The node with this id, or -1. */
    fun find(id: Int): Int {
        val nodes = table
        if (nodes != null) return if (id < nodes.size) nodes[id] else -1
        val at = sorted.binarySearch(id.toLong() shl 32)
        val place = if (at >= 0) at else -at - 1
        return if (place < sorted.size && sorted[place] ushr 32 == id.toLong()) sorted[place].toInt() else -1
    }
}
