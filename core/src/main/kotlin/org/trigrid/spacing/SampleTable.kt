package org.trigrid.spacing

/** Samples of a function by their integer key, numbered in the order in which they came; a flat hash table. */
internal class SampleTable {
    private var keys = LongArray(4096)
    private var places = DoubleArray(8192)
    private var values = DoubleArray(4096)

    /** Open addressing: sample number + 1, or 0 where free; never more than half full. */
    private var slots = IntArray(8192)

    var size = 0
        private set

    /** Number of the sample with the key, or -1. */
    fun find(key: Long): Int = slots[slotOf(key)] - 1

    fun value(sample: Int): Double = values[sample]

    /** x0, y0, x1, y1, … of all samples; a copy. */
    fun places(): DoubleArray = places.copyOf(2 * size)

    /** Adds a sample whose key is not yet known; returns its number. */
    fun add(key: Long, x: Double, y: Double, value: Double): Int {
        if (size == keys.size) grow()
        keys[size] = key
        places[2 * size] = x
        places[2 * size + 1] = y
        values[size] = value
        slots[slotOf(key)] = size + 1
        return size++
    }

    private fun slotOf(key: Long): Int {
        val mask = slots.size - 1
        var slot = ((key * -7046029254386353131L) ushr 32).toInt() and mask
        while (slots[slot] != 0 && keys[slots[slot] - 1] != key) slot = (slot + 1) and mask
        return slot
    }

    private fun grow() {
        keys = keys.copyOf(2 * size)
        places = places.copyOf(4 * size)
        values = values.copyOf(2 * size)
        slots = IntArray(4 * size)
        for (sample in 0 until size) slots[slotOf(keys[sample])] = sample + 1
    }
}
