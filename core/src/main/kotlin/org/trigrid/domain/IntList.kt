package org.trigrid.domain

/** A growing array of ints. */
internal class IntList {
    private var values = IntArray(16)

    var size: Int = 0
        private set

    fun add(value: Int) {
        if (size == values.size) values = values.copyOf(2 * size)
        values[size++] = value
    }

    operator fun get(index: Int): Int = values[index]

    fun toArray(): IntArray = values.copyOf(size)
}
