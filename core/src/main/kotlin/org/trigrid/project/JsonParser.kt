package org.trigrid.project

import org.trigrid.diagnostics.FileFormatException

/** Text of a file and the places in it. */
internal class JsonSource(val text: String, private val name: String) {
    /** @throws FileFormatException with the line and column of [offset]. */
    fun fail(offset: Int, reason: String, cause: Throwable? = null): Nothing {
        val end = Math.min(Math.max(offset, 0), text.length)
        var line = 1
        var lineStart = 0
        for (i in 0 until end) {
            if (text[i] == '\n' || text[i] == '\r' && text.getOrNull(i + 1) != '\n') {
                line++
                lineStart = i + 1
            }
        }
        throw FileFormatException(name, line, end - lineStart + 1, reason, cause)
    }
}

/** Strict JSON (RFC 8259); a key may stand once in an object. */
internal class JsonParser(private val source: JsonSource) {
    private val text = source.text
    private var at = if (text.startsWith(BYTE_ORDER_MARK)) 1 else 0

    /** The one value of the text. */
    fun parse(): JsonValue {
        val value = value(0)
        skipBlanks()
        if (at < text.length) source.fail(at, "nothing may follow the closing bracket")
        return value
    }

    private fun value(depth: Int): JsonValue {
        skipBlanks()
        val begin = at
        if (depth > MAX_DEPTH) source.fail(at, "more than $MAX_DEPTH brackets in one another")
        val value = when (val c = peek()) {
            '{' -> objectValue(depth)
            '[' -> arrayValue(depth)
            '"' -> JsonString(string())
            't' -> word("true", JsonBoolean(true))
            'f' -> word("false", JsonBoolean(false))
            'n' -> word("null", JsonNull())
            else -> if (c == '-' || c in '0'..'9') number() else source.fail(at, "a value was expected, not '$c'")
        }
        value.at = begin
        return value
    }

    private fun objectValue(depth: Int): JsonObject {
        val members = LinkedHashMap<String, JsonMember>()
        at++
        skipBlanks()
        if (peek() == '}') {
            at++
            return JsonObject(members)
        }
        while (true) {
            skipBlanks()
            val keyAt = at
            if (peek() != '"') source.fail(at, "a key in double quotes was expected, not '${peek()}'")
            val key = string()
            if (key in members) source.fail(keyAt, "key \"$key\" stands twice in one object")
            skipBlanks()
            if (peek() != ':') source.fail(at, "':' was expected after the key \"$key\", not '${peek()}'")
            at++
            members[key] = JsonMember(keyAt, value(depth + 1))
            if (!goesOn('}')) return JsonObject(members)
        }
    }

    private fun arrayValue(depth: Int): JsonArray {
        val items = ArrayList<JsonValue>()
        at++
        skipBlanks()
        if (peek() == ']') {
            at++
            return JsonArray(items)
        }
        while (true) {
            items.add(value(depth + 1))
            if (!goesOn(']')) return JsonArray(items)
        }
    }

    /** Passes a comma (true) or the closing bracket (false). */
    private fun goesOn(closing: Char): Boolean {
        skipBlanks()
        val c = peek()
        if (c != ',' && c != closing) source.fail(at, "',' or '$closing' was expected, not '$c'")
        at++
        return c == ','
    }

    private fun string(): String {
        val begin = at++
        val value = StringBuilder()
        while (true) {
            if (at >= text.length) source.fail(begin, "the string that begins here has no end")
            when (val c = text[at]) {
                '"' -> {
                    at++
                    return value.toString()
                }
                '\\' -> value.append(escaped())
                else -> {
                    if (c < ' ') source.fail(at, "a control character in a string")
                    value.append(c)
                    at++
                }
            }
        }
    }

    private fun escaped(): Char {
        val begin = at++
        val c = peek()
        at++
        return when (c) {
            '"', '\\', '/' -> c
            'b' -> '\b'
            'f' -> '\u000c'
            'n' -> '\n'
            'r' -> '\r'
            't' -> '\t'
            'u' -> {
                val digits = text.substring(at, Math.min(at + 4, text.length))
                if (digits.length < 4 || digits.any { Character.digit(it, 16) < 0 }) source.fail(begin, "four hex digits were expected after \\u")
                at += 4
                digits.toInt(16).toChar()
            }
            else -> source.fail(begin, "\\$c is no escape")
        }
    }

    private fun number(): JsonNumber {
        val begin = at
        if (peek() == '-') at++
        val whole = digits()
        if (whole > 1 && text[at - whole] == '0') source.fail(begin, "a number may not begin with 0")
        if (at < text.length && text[at] == '.') {
            at++
            digits()
        }
        if (at < text.length && (text[at] == 'e' || text[at] == 'E')) {
            at++
            if (peek() == '+' || peek() == '-') at++
            digits()
        }
        return JsonNumber(text.substring(begin, at))
    }

    private fun digits(): Int {
        val begin = at
        while (at < text.length && text[at] in '0'..'9') at++
        if (at == begin) source.fail(at, "a digit was expected, not '${peek()}'")
        return at - begin
    }

    private fun word(word: String, value: JsonValue): JsonValue {
        if (!text.startsWith(word, at)) source.fail(at, "a value was expected")
        at += word.length
        return value
    }

    private fun peek(): Char = if (at < text.length) text[at] else source.fail(at, "the text ends too early")

    private fun skipBlanks() {
        while (at < text.length && text[at] in " \t\r\n") at++
    }

    private companion object {
        const val MAX_DEPTH = 64
        const val BYTE_ORDER_MARK = "\uFEFF"
    }
}
