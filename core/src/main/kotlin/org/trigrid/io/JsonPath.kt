package org.trigrid.io

/** Where a value stands in a JSON tree: the keys and indices from the root to it. */
internal class JsonPath private constructor(private val up: JsonPath?, private val step: Any) {
    operator fun get(key: String): JsonPath = JsonPath(this, key)

    operator fun get(index: Int): JsonPath = JsonPath(this, index)

    /** Strings and ints, the root's first; none for the root itself. */
    fun steps(): List<Any> = generateSequence(this) { it.up }.map { it.step }.toList().reversed().drop(1)

    companion object {
        val ROOT: JsonPath = JsonPath(null, "")
    }
}
