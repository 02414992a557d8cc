package org.trigrid.io

/** Where in a JSON text a value stands; works on text that a parser has accepted. */
internal class JsonPlace private constructor(private val text: String) {
    private var at = 0

    private fun seek(path: List<Any>): Int {
        for (step in path) {
            skipSpace()
            val found = if (step is Int) enterElement(step) else enterMember(step as String)
            if (!found) break
        }
        skipSpace()
        return at
    }

    private fun enterElement(index: Int): Boolean {
        if (peek() != '[') return false
        at++
        for (i in 0 until index) {
            skipValue()
            skipSpace()
            if (peek() != ',') return false
            at++
        }
        return true
    }

    /** The last member of that name rules, as it does in the parsed tree. */
    private fun enterMember(name: String): Boolean {
        if (peek() != '{') return false
        var found = -1
        do {
            at++
            skipSpace()
            val start = at
            skipValue()
            val isIt = text.substring(start, at).trim() == "\"$name\""
            skipSpace()
            if (peek() != ':') break
            at++
            if (isIt) found = at
            skipValue()
            skipSpace()
        } while (peek() == ',')
        if (found >= 0) at = found
        return found >= 0
    }

    private fun skipValue() {
        skipSpace()
        var depth = 0
        while (at < text.length) {
            val c = text[at]
            if (depth == 0 && (c == ',' || c == ']' || c == '}' || c == ':')) return
            if (c == '"') skipString() else at++
            if (c == '[' || c == '{') depth++
            if ((c == ']' || c == '}') && --depth == 0) return
            if (c == '"' && depth == 0) return
        }
    }

    private fun skipString() {
        at++
        while (at < text.length && text[at] != '"') at += if (text[at] == '\\') 2 else 1
        at++
    }

    private fun skipSpace() {
        while (at < text.length && text[at].isWhitespace()) at++
    }

    private fun peek(): Char = if (at < text.length) text[at] else '\u0000'

    companion object {
        /** Offset of the value at [path]: member names and element numbers from the root; or as far as it can be followed. */
        fun offsetOf(text: String, path: List<Any>): Int = Math.min(JsonPlace(text).seek(path), text.length)
    }
}
