package org.trigrid.project

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Breaks JSON into lines so that a change of one shape changes few of them: what fits on a line stays on it. The pretty
 * printer of kotlinx-serialization would give every coordinate a line of its own.
 */
internal class JsonPrinter private constructor() {
    private val out = StringBuilder()

    private fun value(value: JsonElement, indent: String) {
        val line = flat(value)
        val column = out.length - (out.lastIndexOf("\n") + 1)
        if (column + line.length <= WIDTH) out.append(line) else broken(value, indent)
    }

    private fun broken(value: JsonElement, indent: String) {
        when (value) {
            is JsonObject -> lines("{", value.entries, "}", indent) { (key, member) ->
                out.append(JsonPrimitive(key)).append(": ")
                value(member, indent + INDENT)
            }
            is JsonArray -> lines("[", value, "]", indent) { value(it, indent + INDENT) }
            is JsonPrimitive -> out.append(value)
        }
    }

    private fun <T> lines(opening: String, items: Collection<T>, closing: String, indent: String, print: (T) -> Unit) {
        out.append(opening)
        for ((i, item) in items.withIndex()) {
            out.append(if (i == 0) "\n" else ",\n").append(indent).append(INDENT)
            print(item)
        }
        out.append('\n').append(indent).append(closing)
    }

    private fun flat(value: JsonElement): String = when (value) {
        is JsonObject -> value.entries.joinToString(", ", "{", "}") { "${JsonPrimitive(it.key)}: ${flat(it.value)}" }
        is JsonArray -> value.joinToString(", ", "[", "]") { flat(it) }
        is JsonPrimitive -> value.toString()
    }

    companion object {
        private const val WIDTH = 110
        private const val INDENT = "  "

        /** The lines of [file], the outermost bracket always broken open. */
        fun print(file: JsonObject): String = JsonPrinter().also { it.broken(file, "") }.out.append('\n').toString()
    }
}
