package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException

/** The lines of a file of Triangle's, split into fields; empty lines, and what follows a `#`, do not count. */
internal class PolyLines(val source: String, text: String) {
    private val lines = linesOf(text)
    private var line = -1

    /** Where the fields of the line start and end, two for each. */
    private var bounds = IntArray(16)

    var fieldCount: Int = 0
        private set

    /** Of the line at hand, from 1. */
    val lineNumber: Int get() = line + 1

    private fun linesOf(text: String): List<String> {
        ReadingMemory.check(source, text.length, ReadingMemory.POLY * text.length)
        return text.lines()
    }

    fun hasNext(): Boolean = (line + 1 until lines.size).any { split(lines[it]) > 0 }

    /** @param what is expected there, for the error if the file ends before. */
    fun next(what: String) {
        do {
            line++
            if (line >= lines.size) throw FileFormatException(source, lines.size, 0, "the file ends before $what")
            fieldCount = split(lines[line])
        } while (fieldCount == 0)
    }

    fun int(field: Int): Int = field(field).toIntOrNull() ?: fail(field, "\"${field(field)}\" is not a whole number")

    fun double(field: Int): Double {
        val value = RingPoints.decimal(field(field))
        if (value.isNaN()) fail(field, "\"${field(field)}\" is not a number")
        return value
    }

    fun count(field: Int, what: String): Int {
        val count = int(field)
        if (count < 0 || count > lines.size) fail(field, "$count is not a number of $what of this file")
        return count
    }

    fun fail(field: Int, reason: String): Nothing {
        val column = if (field < fieldCount) bounds[2 * field] else lines[line].trimEnd().length
        throw FileFormatException(source, line + 1, column + 1, reason)
    }

    private fun field(field: Int): String {
        if (field >= fieldCount) fail(field, "a number is missing")
        return lines[line].substring(bounds[2 * field], bounds[2 * field + 1])
    }

    private fun split(text: String): Int {
        var count = 0
        var at = 0
        while (at < text.length && text[at] != '#') {
            val start = at
            while (at < text.length && !isBetweenFields(text[at])) at++
            if (at == start) {
                at++
                continue
            }
            if (2 * count == bounds.size) bounds = bounds.copyOf(4 * count)
            bounds[2 * count] = start
            bounds[2 * count + 1] = at
            count++
        }
        return count
    }

    private fun isBetweenFields(c: Char) = c.isWhitespace() || c == ',' || c == '#'
}
