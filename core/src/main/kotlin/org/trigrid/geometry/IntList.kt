package org.trigrid.geometry

/** A growing array of ints. */
internal class IntList {
    private var items = IntArray(16)

    var size: Int = 0
        private set

    operator fun get(index: Int): Int = items[index]

    operator fun set(index: Int, item: Int) {
        items[index] = item
    }

    fun add(item: Int) {
        if (size == items.size) items = items.copyOf(2 * size)
        items[size++] = item
    }

    fun removeLast(): Int = items[--size]

    fun clear() {
        size = 0
    }

    fun reverse() {
        items.reverse(0, size)
    }

    fun toArray(): IntArray = items.copyOf(size)
}
