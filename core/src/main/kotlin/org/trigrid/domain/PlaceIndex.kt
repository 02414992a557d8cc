package org.trigrid.domain

/**
 * Numbers places: equal coordinates get the same number, in the order of their first coming.
 *
 * `0.0` and `-0.0` are one place; a place with a NaN equals no other. Open addressing over the coordinates' bits.
 */
internal class PlaceIndex(expectedCount: Int) {
    private var coordinates = DoubleArray(2 * maxOf(8, expectedCount))
    private var slots = emptySlots(maxOf(8, expectedCount))

    var count: Int = 0
        private set

    /** The number of the place (x, y): that of its first coming, or the next free one. */
    fun numberOf(x: Double, y: Double): Int {
        var slot = hash(x, y) and (slots.size - 1)
        while (slots[slot] >= 0) {
            val number = slots[slot]
            if (coordinates[2 * number] == x && coordinates[2 * number + 1] == y) return number
            slot = (slot + 1) and (slots.size - 1)
        }
        slots[slot] = count
        return add(x, y)
    }

    /** x0, y0, x1, y1, … as they first came. A copy. */
    fun toArray(): DoubleArray = coordinates.copyOf(2 * count)

    private fun add(x: Double, y: Double): Int {
        if (2 * count == coordinates.size) coordinates = coordinates.copyOf(2 * coordinates.size)
        coordinates[2 * count] = x
        coordinates[2 * count + 1] = y
        count++
        if (2 * count > slots.size) rehash()
        return count - 1
    }

    private fun rehash() {
        slots = emptySlots(slots.size)
        for (number in 0 until count) {
            var slot = hash(coordinates[2 * number], coordinates[2 * number + 1]) and (slots.size - 1)
            while (slots[slot] >= 0) slot = (slot + 1) and (slots.size - 1)
            slots[slot] = number
        }
    }

    private fun emptySlots(count: Int): IntArray = IntArray(Integer.highestOneBit(count) * 4).also { it.fill(-1) }

    /** Adding 0.0 turns -0.0 into 0.0; the multipliers spread bits that lie only in the mantissa's top. */
    private fun hash(x: Double, y: Double): Int {
        val bits = (x + 0.0).toRawBits() * -0x61c8864680b583ebL + (y + 0.0).toRawBits() * -0x3d4d51c2d82b14b1L
        val mixed = (bits xor (bits ushr 32)) * -0x61c8864680b583ebL
        return (mixed ushr 32).toInt() and Int.MAX_VALUE
    }
}
