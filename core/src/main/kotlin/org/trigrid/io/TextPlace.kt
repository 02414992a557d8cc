package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException

/** A complaint about a text at one of its characters. */
internal object TextPlace {
    /** @param offset 0-based; what lies past the end means the end. */
    fun exception(source: String, text: String, offset: Int, reason: String, cause: Throwable? = null): FileFormatException {
        val end = Math.min(Math.max(offset, 0), text.length)
        var line = 1
        var lineStart = 0
        for (i in 0 until end) {
            if (text[i] == '\n' || text[i] == '\r' && text.getOrNull(i + 1) != '\n') {
                line++
                lineStart = i + 1
            }
        }
        return FileFormatException(source, line, end - lineStart + 1, reason, cause)
    }
}
