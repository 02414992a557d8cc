package org.trigrid.project

/** Prints JSON so that a change of one shape changes few lines: what fits on a line stays on it, the rest is broken open. */
internal object JsonPrinter {
    private const val WIDTH = 110
    private const val INDENT = "  "

    fun print(value: JsonValue): String = StringBuilder().also { broken(value, "", it) }.append('\n').toString()

    private fun value(value: JsonValue, indent: String, out: StringBuilder) {
        val line = flat(value)
        val column = out.length - (out.lastIndexOf("\n") + 1)
        if (column + line.length <= WIDTH) out.append(line) else broken(value, indent, out)
    }

    private fun broken(value: JsonValue, indent: String, out: StringBuilder) {
        when {
            value is JsonObject && value.members.isNotEmpty() -> {
                out.append("{")
                var separator = "\n"
                for ((key, member) in value.members) {
                    out.append(separator).append(indent).append(INDENT).append(quoted(key)).append(": ")
                    value(member.value, indent + INDENT, out)
                    separator = ",\n"
                }
                out.append("\n").append(indent).append("}")
            }
            value is JsonArray && value.items.isNotEmpty() -> {
                out.append("[")
                var separator = "\n"
                for (item in value.items) {
                    out.append(separator).append(indent).append(INDENT)
                    value(item, indent + INDENT, out)
                    separator = ",\n"
                }
                out.append("\n").append(indent).append("]")
            }
            else -> out.append(flat(value))
        }
    }

    private fun flat(value: JsonValue): String = when (value) {
        is JsonObject -> value.members.entries.joinToString(", ", "{", "}") { "${quoted(it.key)}: ${flat(it.value.value)}" }
        is JsonArray -> value.items.joinToString(", ", "[", "]") { flat(it) }
        is JsonString -> quoted(value.value)
        is JsonNumber -> value.text
        is JsonBoolean -> value.value.toString()
        is JsonNull -> "null"
    }

    private fun quoted(text: String): String = buildString {
        append('"')
        for (c in text) {
            when {
                c == '"' || c == '\\' -> append('\\').append(c)
                c < ' ' || c.isSurrogate() -> append("\\u").append(String.format(java.util.Locale.ROOT, "%04x", c.code))
                else -> append(c)
            }
        }
        append('"')
    }
}
