package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException

/** The lines of a file of Triangle's, split into fields; empty lines, and what follows a `#`, do not count. */
internal class PolyLines(private val source: String, text: String) {
    private val lines = text.lines()
    private var line = -1
    private var fields: List<MatchResult> = emptyList()

    val fieldCount: Int get() = fields.size

    fun hasNext(): Boolean = (line + 1 until lines.size).any { fieldsOf(it).isNotEmpty() }

    /** @param what is expected there, for the error if the file ends before. */
    fun next(what: String) {
        do {
            line++
            if (line >= lines.size) throw FileFormatException(source, lines.size, 0, "the file ends before $what")
            fields = fieldsOf(line)
        } while (fields.isEmpty())
    }

    fun int(field: Int): Int = field(field).toIntOrNull() ?: fail(field, "\"${field(field)}\" is not a whole number")

    fun double(field: Int): Double {
        val text = field(field)
        if (!RingPoints.isDecimal(text)) fail(field, "\"$text\" is not a number")
        return text.toDouble()
    }

    fun count(field: Int, what: String): Int {
        val count = int(field)
        if (count < 0 || count > MOST) fail(field, "$count is not a number of $what")
        return count
    }

    fun fail(field: Int, reason: String): Nothing {
        val column = fields.getOrNull(field)?.range?.first?.plus(1) ?: (lines[line].trimEnd().length + 1)
        throw FileFormatException(source, line + 1, column, reason)
    }

    private fun field(field: Int): String = fields.getOrNull(field)?.value ?: fail(field, "a number is missing")

    private fun fieldsOf(line: Int) = FIELD.findAll(lines[line].substringBefore('#')).toList()

    private companion object {
        val FIELD = Regex("[^\\s,]+")

        /** As many as arrays of two coordinates each have room for. */
        const val MOST = 500_000_000
    }
}
