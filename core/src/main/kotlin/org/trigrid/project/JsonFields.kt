package org.trigrid.project

import org.trigrid.geometry.Point2
import java.math.BigDecimal

/**
 * The members of an object, taken one by one with their types; [end] refuses what nobody asked for.
 *
 * All functions throw [org.trigrid.diagnostics.FileFormatException] with the place of what is wrong.
 */
internal class JsonFields(private val source: JsonSource, private val value: JsonValue, private val what: String) {
    private val members = (value as? JsonObject)?.members
        ?: source.fail(value.at, "$what must be an object, not ${value.kind}")
    private val asked = LinkedHashSet<String>()

    fun has(key: String): Boolean {
        asked.add(key)
        return key in members
    }

    fun any(key: String): JsonValue {
        if (!has(key)) source.fail(value.at, "$what lacks the key \"$key\"")
        return members.getValue(key).value
    }

    fun string(key: String): String {
        val value = any(key)
        return (value as? JsonString)?.value ?: wrong(key, "a string", value)
    }

    fun string(key: String, default: String): String = if (has(key)) string(key) else default

    fun boolean(key: String, default: Boolean): Boolean {
        if (!has(key)) return default
        val value = any(key)
        return (value as? JsonBoolean)?.value ?: wrong(key, "true or false", value)
    }

    fun number(key: String): Double = number(key, any(key))

    fun number(key: String, default: Double): Double = if (has(key)) number(key) else default

    fun whole(key: String): Int {
        val value = any(key)
        val text = (value as? JsonNumber)?.text ?: wrong(key, "a whole number", value)
        return try {
            BigDecimal(text).intValueExact()
        } catch (e: ArithmeticException) {
            source.fail(value.at, "\"$key\" must be a whole number of at most 32 bits, not $text", e)
        }
    }

    fun <E : Enum<E>> choice(key: String, choices: List<E>): E {
        val text = string(key)
        return choices.firstOrNull { word(it) == text }
            ?: source.fail(any(key).at, "\"$key\" must be one of ${choices.joinToString { word(it) }}, not \"$text\"")
    }

    fun <E : Enum<E>> choice(key: String, choices: List<E>, default: E): E =
        if (has(key)) choice(key, choices) else default

    fun point(key: String): Point2 = point(key, any(key))

    fun points(key: String): List<Point2> = items(key).mapIndexed { i, item -> point("$key $i", item) }

    fun strings(key: String): List<String> = items(key).mapIndexed { i, item ->
        (item as? JsonString)?.value ?: wrong("$key $i", "a string", item)
    }

    fun items(key: String): List<JsonValue> {
        val value = any(key)
        return (value as? JsonArray)?.items ?: wrong(key, "an array", value)
    }

    /** Refuses the first member that was not asked for. */
    fun end() {
        val unknown = members.entries.firstOrNull { it.key !in asked } ?: return
        source.fail(unknown.value.keyAt, "unknown key \"${unknown.key}\" in $what; it may have ${asked.joinToString()}")
    }

    /** Refuses the member whose key [reason] names, or the whole object. */
    fun refuse(reason: String, cause: Throwable): Nothing {
        val words = reason.split(' ', ':').toSet()
        val member = members.entries.firstOrNull { it.key in words }
        source.fail(member?.value?.value?.at ?: value.at, reason, cause)
    }

    private fun point(what: String, value: JsonValue): Point2 {
        val items = (value as? JsonArray)?.items ?: wrong(what, "a point [x, y]", value)
        if (items.size != 2) source.fail(value.at, "\"$what\" must be a point [x, y], not ${items.size} values")
        return Point2(number(what, items[0]), number(what, items[1]))
    }

    private fun number(key: String, value: JsonValue): Double {
        val text = (value as? JsonNumber)?.text ?: wrong(key, "a number", value)
        val number = text.toDouble()
        if (number.isInfinite()) source.fail(value.at, "\"$key\" is beyond the range of numbers: $text")
        return number
    }

    private fun wrong(key: String, wanted: String, value: JsonValue): Nothing =
        source.fail(value.at, "\"$key\" must be $wanted, not ${value.kind}")

    companion object {
        /** The word of an enumeration's value in a file: `CUTHILL_MCKEE` is `cuthill-mckee`. */
        fun word(value: Enum<*>): String = value.name.lowercase().replace('_', '-')
    }
}
