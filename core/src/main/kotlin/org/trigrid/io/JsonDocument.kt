package org.trigrid.io

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonDecodingException
import kotlinx.serialization.json.JsonElement
import org.trigrid.diagnostics.FileFormatException

/**
 * A parsed JSON text whose faults can be told by line and column.
 *
 * @param source names the text in errors.
 * @throws FileFormatException if [text] is not JSON, has more than [MAX_DEPTH] brackets in one another, or, with
 *   [uniqueKeys], has a key twice in one object.
 */
internal class JsonDocument(private val text: String, private val source: String, uniqueKeys: Boolean) {
    val root: JsonElement

    init {
        checkWalk(uniqueKeys)
        root = parse()
    }

    /** @throws FileFormatException with the place of the value at [path], or of what is there of the way to it. */
    fun fail(path: JsonPath, reason: String, cause: Throwable? = null): Nothing =
        throw TextPlace.exception(source, text, offsetOf(path.steps()) { it.valueAt }, reason, cause)

    /** @throws FileFormatException with the place of the key of the value at [path]. */
    fun failAtKey(path: JsonPath, reason: String): Nothing =
        throw TextPlace.exception(source, text, offsetOf(path.steps()) { it.keyAt }, reason)

    /** Before parsing, as a tree of any depth is more than its later use could bear. */
    private fun checkWalk(uniqueKeys: Boolean) {
        val walk = JsonWalk(text)
        var values = 0L
        while (walk.next()) {
            values++
            if (walk.depth > MAX_DEPTH) {
                throw TextPlace.exception(source, text, walk.valueAt, "more than $MAX_DEPTH brackets in one another")
            }
            if (uniqueKeys && walk.repeatsKey) {
                throw TextPlace.exception(source, text, walk.keyAt, "key \"${walk.key}\" stands twice in one object")
            }
        }
        ReadingMemory.check(source, text.length, ReadingMemory.TEXT * text.length + ReadingMemory.JSON_VALUE * values)
    }

    @OptIn(ExperimentalSerializationApi::class)
    private fun parse(): JsonElement = try {
        Json.parseToJsonElement(text)
    } catch (e: JsonDecodingException) {
        val offset = if (e.offset < 0) text.length else e.offset
        throw TextPlace.exception(source, text, offset, "not JSON: ${e.shortMessage}", e)
    } catch (e: SerializationException) {
        throw TextPlace.exception(source, text, text.length, "not JSON: ${e.message}", e)
    }

    /** Of the last value on the way of [steps] that is there; the last of repeated keys rules, as in the tree. */
    private fun offsetOf(steps: List<Any>, place: (JsonWalk) -> Int): Int {
        val walk = JsonWalk(text)
        var most = -1
        var offset = 0
        while (walk.next()) {
            val matched = walk.matches(steps)
            if (matched < most || matched < 0) continue
            most = matched
            offset = place(walk)
        }
        return offset
    }

    private companion object {
        const val MAX_DEPTH = 64
    }
}
