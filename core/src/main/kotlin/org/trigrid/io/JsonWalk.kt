package org.trigrid.io

import kotlinx.serialization.json.Json

/**
 * One pass over a JSON text, value by value, for what a parsed tree does not tell: where the values stand, how deep
 * brackets are nested and which keys are repeated.
 *
 * The walk of a text that is no JSON ends as well, but what it finds there means nothing.
 */
internal class JsonWalk(private val text: String) {
    private val levels = ArrayList<Level>()
    private var at = 0

    /** Offset of the value. */
    var valueAt: Int = -1
        private set

    /** Offset of the value's key; of the key last passed if the value has none. */
    var keyAt: Int = -1
        private set

    /** Whether the object had the value's key before. */
    var repeatsKey: Boolean = false
        private set

    /** Number of brackets round the value. */
    val depth: Int get() = levels.size

    /** The value's key, or null for the root and the elements of arrays. */
    val key: String? get() = levels.lastOrNull()?.key

    /** An open bracket, and the key or index of the value within it. */
    private class Level(val isObject: Boolean) {
        val keys = if (isObject) HashSet<String>() else null
        var key: String? = null
        var index = 0
    }

    /** Goes to the next value, an array or object before what is in it; false if there is none. */
    fun next(): Boolean {
        when (if (valueAt < 0) BLANK else text[valueAt]) {
            '{' -> levels.add(Level(true))
            '[' -> levels.add(Level(false))
        }
        repeatsKey = false
        while (at < text.length) {
            when (val c = text[at]) {
                ',' -> passComma()
                ']', '}' -> leave()
                '"' -> if (awaitsKey()) passKey() else return passValue(c)
                else -> if (c == ':' || c.isWhitespace()) at++ else return passValue(c)
            }
        }
        return false
    }

    /** How many [steps] from the root agree with the way to the value, or -1 if the value is elsewhere. */
    fun matches(steps: List<Any>): Int {
        if (levels.size > steps.size) return -1
        for ((i, level) in levels.withIndex()) {
            if (steps[i] != (if (level.isObject) level.key else level.index)) return -1
        }
        return levels.size
    }

    private fun awaitsKey(): Boolean = levels.lastOrNull().let { it != null && it.isObject && it.key == null }

    private fun passKey() {
        keyAt = at
        passString()
        val quoted = text.substring(keyAt, at)
        val level = levels.last()
        val key = if ('\\' in quoted) decoded(quoted) else quoted.removeSurrounding("\"")
        repeatsKey = !level.keys!!.add(key)
        level.key = key
    }

    private fun decoded(quoted: String): String = try {
        Json.decodeFromString<String>(quoted)
    } catch (_: IllegalArgumentException) {
        quoted
    }

    private fun passValue(first: Char): Boolean {
        valueAt = at
        when (first) {
            '"' -> passString()
            '{', '[' -> at++
            else -> while (at < text.length && text[at] !in ENDS && !text[at].isWhitespace()) at++
        }
        return true
    }

    private fun passComma() {
        at++
        val level = levels.lastOrNull() ?: return
        level.key = null
        level.index++
    }

    private fun leave() {
        at++
        if (levels.isNotEmpty()) levels.removeAt(levels.lastIndex)
    }

    private fun passString() {
        at++
        while (at < text.length && text[at] != '"') at += if (text[at] == '\\') 2 else 1
        at = Math.min(at + 1, text.length)
    }

    private companion object {
        const val BLANK = ' '
        const val ENDS = ",:[]{}\""
    }
}
