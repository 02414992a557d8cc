package org.trigrid.project

/**
 * A JSON value that knows where it stood.
 *
 * The reading of project files needs the place of every value for its messages, and refuses repeated keys and quoted
 * numbers, which serialization libraries let pass; hence this small tree.
 */
internal sealed class JsonValue {
    /** Offset of the value's first character in the text; -1 for a value that was not read. */
    var at: Int = -1

    /** What the value is, for messages. */
    abstract val kind: String
}

internal class JsonObject(val members: LinkedHashMap<String, JsonMember> = LinkedHashMap()) : JsonValue() {
    override val kind: String get() = "an object"

    operator fun set(key: String, value: JsonValue) {
        members[key] = JsonMember(-1, value)
    }

    operator fun set(key: String, value: String) = set(key, JsonString(value))

    operator fun set(key: String, value: Double) = set(key, JsonNumber(NumberText.of(value)))
}

internal class JsonMember(val keyAt: Int, val value: JsonValue)

internal class JsonArray(val items: List<JsonValue>) : JsonValue() {
    override val kind: String get() = "an array"
}

internal class JsonString(val value: String) : JsonValue() {
    override val kind: String get() = "a string"
}

/** A number as written, so that no digit is lost before its type is known. */
internal class JsonNumber(val text: String) : JsonValue() {
    override val kind: String get() = "a number"
}

internal class JsonBoolean(val value: Boolean) : JsonValue() {
    override val kind: String get() = "$value"
}

internal class JsonNull : JsonValue() {
    override val kind: String get() = "null"
}
