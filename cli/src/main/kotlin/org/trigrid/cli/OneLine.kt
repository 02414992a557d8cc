package org.trigrid.cli

/** Makes messages that hold names of files, or words of files, one line of what can be seen. */
internal object OneLine {
    /** Signs that break a line or command a terminal become escapes such as `\n` and `\u001b`. */
    fun of(text: String): String {
        if (text.none { it.isISOControl() }) return text
        return buildString {
            for (c in text) {
                when {
                    c == '\n' -> append("\\n")
                    c == '\t' -> append("\\t")
                    c.isISOControl() -> append("\\u").append("%04x".format(c.code))
                    else -> append(c)
                }
            }
        }
    }
}
