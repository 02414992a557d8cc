package org.trigrid.front

/**
 * Front edges by a small integer key, smallest first; among equal keys the one queued first.
 *
 * Buckets are doubly linked lists threaded through arrays over the edges, and a bit per bucket in words of three
 * levels finds the first bucket that is not empty: every operation is O(1).
 */
internal class FrontQueue(private val keyCount: Int) {
    private val bits0 = LongArray((keyCount + 63) / 64)
    private val bits1 = LongArray((bits0.size + 63) / 64)
    private val bits2 = LongArray((bits1.size + 63) / 64)

    /** The ring of each bucket begins and ends at its key; edge e is at [keyCount] + e. */
    private var after = IntArray(keyCount + 64) { it }
    private var before = IntArray(keyCount + 64) { it }
    private var keyOf = IntArray(64).apply { fill(-1) }

    fun contains(edge: Int): Boolean = edge < keyOf.size && keyOf[edge] >= 0

    /** Queues [edge] with [key], 0 until keyCount (clamped), or moves it there; with the same key it keeps its turn. */
    fun put(edge: Int, key: Int) {
        val k = Math.min(Math.max(key, 0), keyCount - 1)
        if (edge >= keyOf.size) grow(edge)
        if (keyOf[edge] == k) return
        if (keyOf[edge] >= 0) remove(edge)
        keyOf[edge] = k
        val at = keyCount + edge
        val tail = before[k]
        before[at] = tail
        after[at] = k
        after[tail] = at
        before[k] = at
        mark(k)
    }

    fun remove(edge: Int) {
        if (edge >= keyOf.size) return
        val k = keyOf[edge]
        if (k < 0) return
        keyOf[edge] = -1
        val b = before[keyCount + edge]
        val a = after[keyCount + edge]
        after[b] = a
        before[a] = b
        if (a == b && a == k) unmark(k)
    }

    /** The edge with the smallest key, or -1; it stays queued. */
    fun peek(): Int {
        for (w2 in bits2.indices) {
            if (bits2[w2] == 0L) continue
            val w1 = 64 * w2 + java.lang.Long.numberOfTrailingZeros(bits2[w2])
            val w0 = 64 * w1 + java.lang.Long.numberOfTrailingZeros(bits1[w1])
            return after[64 * w0 + java.lang.Long.numberOfTrailingZeros(bits0[w0])] - keyCount
        }
        return -1
    }

    private fun mark(k: Int) {
        bits0[k shr 6] = bits0[k shr 6] or (1L shl k)
        bits1[k shr 12] = bits1[k shr 12] or (1L shl (k shr 6))
        bits2[k shr 18] = bits2[k shr 18] or (1L shl (k shr 12))
    }

    private fun unmark(k: Int) {
        bits0[k shr 6] = bits0[k shr 6] and (1L shl k).inv()
        if (bits0[k shr 6] != 0L) return
        bits1[k shr 12] = bits1[k shr 12] and (1L shl (k shr 6)).inv()
        if (bits1[k shr 12] != 0L) return
        bits2[k shr 18] = bits2[k shr 18] and (1L shl (k shr 12)).inv()
    }

    private fun grow(edge: Int) {
        val old = keyOf.size
        val size = Math.max(2 * old, edge + 1)
        keyOf = keyOf.copyOf(size)
        keyOf.fill(-1, old, size)
        after = after.copyOf(keyCount + size)
        before = before.copyOf(keyCount + size)
    }
}
