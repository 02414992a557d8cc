package org.trigrid.project

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import org.trigrid.io.JsonDocument
import org.trigrid.io.JsonPath

/** A value of a JSON document that knows where it stands. */
internal class JsonValue(private val document: JsonDocument, private val path: JsonPath, val element: JsonElement) {
    constructor(document: JsonDocument) : this(document, JsonPath.ROOT, document.root)

    /** What the value is, for messages. */
    val kind: String
        get() = when (element) {
            is JsonObject -> "an object"
            is JsonArray -> "an array"
            is JsonNull -> "null"
            is JsonPrimitive -> if (element.isString) "a string" else if (numberText() != null) "a number" else element.content
        }

    /** The text of a string, or null if the value is another. */
    fun stringText(): String? = (element as? JsonPrimitive)?.takeIf { it.isString }?.content

    /** A number as written, so that no digit is lost before its type is known; or null if the value is another. */
    fun numberText(): String? = bareText()?.takeIf { NUMBER.matches(it) }

    /** True or false, or null if the value is another. */
    fun boolean(): Boolean? = bareText()?.toBooleanStrictOrNull()

    /** The elements of an array, or null if the value is another. */
    fun items(): List<JsonValue>? =
        (element as? JsonArray)?.mapIndexed { i, item -> JsonValue(document, path[i], item) }

    /** The members of an object, or null if the value is another. */
    fun members(): Map<String, JsonValue>? =
        (element as? JsonObject)?.mapValues { (key, member) -> JsonValue(document, path[key], member) }

    /** @throws org.trigrid.diagnostics.FileFormatException with the value's place. */
    fun fail(reason: String, cause: Throwable? = null): Nothing = document.fail(path, reason, cause)

    /** @throws org.trigrid.diagnostics.FileFormatException with the place of the value's key. */
    fun failAtKey(reason: String): Nothing = document.failAtKey(path, reason)

    private fun bareText(): String? = (element as? JsonPrimitive)?.takeIf { !it.isString }?.content

    private companion object {
        /** RFC 8259, section 6; the parser leaves it to the reader of a bare word whether it is a number. */
        val NUMBER = Regex("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?")
    }
}
