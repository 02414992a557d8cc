package org.trigrid.project

import org.trigrid.geometry.Point2
import java.math.BigDecimal

/**
 * The members of an object, taken one by one with their types; [end] refuses what nobody asked for.
 *
 * All functions throw [org.trigrid.diagnostics.FileFormatException] with the place of what is wrong.
 */
internal class JsonFields(private val value: JsonValue, private val what: String) {
    private val members = value.members() ?: value.fail("$what must be an object, not ${value.kind}")
    private val asked = LinkedHashSet<String>()

    fun has(key: String): Boolean {
        asked.add(key)
        return key in members
    }

    /** All keys, in the order of the file. */
    fun keys(): List<String> = members.keys.toList()

    fun any(key: String): JsonValue {
        if (!has(key)) value.fail("$what lacks the key \"$key\"")
        return members.getValue(key)
    }

    fun string(key: String): String = any(key).let { it.stringText() ?: wrong(key, "a string", it) }

    fun string(key: String, default: String): String = if (has(key)) string(key) else default

    fun boolean(key: String, default: Boolean): Boolean {
        if (!has(key)) return default
        return any(key).let { it.boolean() ?: wrong(key, "true or false", it) }
    }

    fun number(key: String): Double = number(key, any(key))

    fun number(key: String, default: Double): Double = if (has(key)) number(key) else default

    fun whole(key: String): Int {
        val value = any(key)
        val text = value.numberText() ?: wrong(key, "a whole number", value)
        val reason = "\"$key\" must be a whole number of at most 32 bits, not $text"
        if (text.length > MOST_DIGITS) value.fail(reason)
        return try {
            BigDecimal(text).intValueExact()
        } catch (e: ArithmeticException) {
            value.fail(reason, e)
        } catch (e: NumberFormatException) {
            value.fail(reason, e)
        }
    }

    fun <E : Enum<E>> choice(key: String, choices: List<E>): E {
        val text = string(key)
        return choices.firstOrNull { word(it) == text }
            ?: any(key).fail("\"$key\" must be one of ${choices.joinToString { word(it) }}, not \"$text\"")
    }

    fun <E : Enum<E>> choice(key: String, choices: List<E>, default: E): E =
        if (has(key)) choice(key, choices) else default

    fun point(key: String): Point2 = point(key, any(key))

    fun points(key: String): List<Point2> = items(key).mapIndexed { i, item -> point("$key $i", item) }

    fun strings(key: String): List<String> = items(key).mapIndexed { i, item ->
        item.stringText() ?: wrong("$key $i", "a string", item)
    }

    fun items(key: String): List<JsonValue> = any(key).let { it.items() ?: wrong(key, "an array", it) }

    /** Refuses the first member that was not asked for. */
    fun end() {
        val unknown = members.entries.firstOrNull { it.key !in asked } ?: return
        unknown.value.failAtKey("unknown key \"${unknown.key}\" in $what; it may have ${asked.joinToString()}")
    }

    /** Refuses the member whose key [reason] names, or the whole object. */
    fun refuse(reason: String, cause: Throwable): Nothing {
        val words = reason.split(' ', ':').toSet()
        val member = members.entries.firstOrNull { it.key in words }
        (member?.value ?: value).fail(reason, cause)
    }

    private fun point(what: String, value: JsonValue): Point2 {
        val items = value.items() ?: wrong(what, "a point [x, y]", value)
        if (items.size != 2) value.fail("\"$what\" must be a point [x, y], not ${items.size} values")
        return Point2(number(what, items[0]), number(what, items[1]))
    }

    private fun number(key: String, value: JsonValue): Double {
        val text = value.numberText() ?: wrong(key, "a number", value)
        val number = text.toDouble()
        if (number.isInfinite()) value.fail("\"$key\" is beyond the range of numbers: $text")
        return number
    }

    private fun wrong(key: String, wanted: String, value: JsonValue): Nothing =
        value.fail("\"$key\" must be $wanted, not ${value.kind}")

    companion object {
        /** Characters of a whole number, which may have an exponent or noughts behind the point; more would only cost time. */
        private const val MOST_DIGITS = 100

        /** The word of an enumeration's value in a file: `CUTHILL_MCKEE` is `cuthill-mckee`. */
        fun word(value: Enum<*>): String = value.name.lowercase().replace('_', '-')
    }
}
