package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Reads words and numbers from the bytes of a file: separated by blanks and line ends, or between [startBinary] and
 * [endBinary] as binary ones.
 */
internal class MshScanner(
    private val bytes: ByteArray,
    private val source: String,
    /** Begins a comment up to the end of its line; a blank for none. */
    private val comment: Char = ' ',
) : Complaint {
    private var at = 0
    private var isBinary = false
    private var binaryStart = 0
    private var sizeBytes = Int.SIZE_BYTES
    private val buffer = ByteBuffer.wrap(bytes)

    /** Where the word read last begins. */
    private var wordStart = 0

    /** Whether only blanks are left. */
    fun atEnd(): Boolean {
        skipBlanks()
        return at >= bytes.size
    }

    /** The next word. */
    fun word(what: String): String {
        startWord(what)
        while (at < bytes.size && !isBlank(bytes[at])) at++
        return String(bytes, wordStart, at - wordStart, Charsets.UTF_8)
    }

    /** What is left of this line, without the blanks round it. */
    fun restOfLine(): String {
        val from = at
        while (at < bytes.size && bytes[at] != NEW_LINE) at++
        return String(bytes, from, at - from, Charsets.UTF_8).trim()
    }

    /** Skips lines up to and with the one that is [line]. */
    fun skipTo(line: String) {
        while (!atEnd()) {
            wordStart = at
            if (restOfLine() == line) return
        }
        fail("the file ends before $line")
    }

    /** The next word must be [expected]. */
    fun expect(expected: String) {
        val found = word(expected)
        if (found != expected) fail("expected $expected, found '$found'")
    }

    /** The next word is the number 1 in four bytes, in the order of the file's numbers. */
    fun readByteOrder() {
        startBinary(Int.SIZE_BYTES)
        buffer.order(ByteOrder.LITTLE_ENDIAN)
        val value = buffer.getInt(take(Int.SIZE_BYTES, "the number that tells the byte order"))
        if (value != 1 && value != 1 shl 24) fail("the number that tells the byte order of binary data is not 1")
        if (value != 1) buffer.order(ByteOrder.BIG_ENDIAN)
        endBinary()
    }

    /** From the next line on numbers are binary; those read by [size] and [count] have [sizeBytes] bytes. */
    fun startBinary(sizeBytes: Int) {
        while (at < bytes.size && bytes[at] != NEW_LINE) at++
        at = minOf(at + 1, bytes.size)
        binaryStart = at
        this.sizeBytes = sizeBytes
        isBinary = true
    }

    /** Words and numbers are text again. */
    fun endBinary() {
        isBinary = false
    }

    private fun take(size: Int, what: String): Int {
        wordStart = at
        if (size > bytes.size - at) fail("the file ends where $what should be")
        at += size
        return wordStart
    }

    /** A whole number of at least [least] that counts or names; in binary files it may have 8 bytes. */
    fun size(what: String, least: Int): Int {
        if (!isBinary) return int(what, least)
        val place = take(sizeBytes, what)
        val value = if (sizeBytes == Long.SIZE_BYTES) buffer.getLong(place) else buffer.getInt(place).toLong()
        if (value < least || value > Int.MAX_VALUE) fail("$what must be from $least to ${Int.MAX_VALUE}, not $value")
        return value.toInt()
    }

    /** A whole number of at least [least]. */
    fun int(what: String, least: Int): Int {
        if (isBinary) {
            val number = buffer.getInt(take(Int.SIZE_BYTES, what))
            if (number < least) fail("$what must be at least $least, not $number")
            return number
        }
        startWord(what)
        val negative = bytes[at] == MINUS
        if (negative || bytes[at] == PLUS) at++
        var value = 0L
        val from = at
        while (at < bytes.size && isDigit(bytes[at]) && value <= Int.MAX_VALUE) value = 10 * value + (bytes[at++] - ZERO)
        if (negative) value = -value
        if (at == from || at < bytes.size && !isBlank(bytes[at])) fail("expected $what, a whole number, found '${wholeWord()}'")
        if (value < least || value > Int.MAX_VALUE) fail("$what must be from $least to ${Int.MAX_VALUE}, not ${wholeWord()}")
        return value.toInt()
    }

    /** How many things follow; no more than the file can hold. */
    fun count(what: String): Int {
        val count = size(what, 0)
        if (count > bytes.size / 2) fail("$what is $count, more than the file can hold")
        return count
    }

    /** A finite number. */
    fun double(what: String): Double {
        if (isBinary) {
            val number = buffer.getDouble(take(Double.SIZE_BYTES, what))
            if (!number.isFinite()) fail("expected $what, a finite number, found $number")
            return number
        }
        startWord(what)
        val quick = quickDouble()
        if (!quick.isNaN()) return quick
        at = wordStart
        val word = word(what)
        val value = if (word.last() in "fFdD") null else word.toDoubleOrNull()
        if (value == null || !value.isFinite()) fail("expected $what, a finite number, found '$word'")
        return value
    }

    /**
     * A number of at most 2^53 as digits with a power of ten that is itself a double: one rounding, so exact (Clinger
     * 1990, PLDI, 92-101). NaN for all others.
     */
    private fun quickDouble(): Double {
        val negative = bytes[at] == MINUS
        if (negative) at++
        var digits = 0L
        var scale = 0
        var count = 0
        var pointSeen = false
        while (at < bytes.size) {
            val b = bytes[at]
            if (isDigit(b)) {
                digits = 10 * digits + (b - ZERO)
                if (digits > EXACT_INTEGER) return Double.NaN
                count++
                if (pointSeen) scale--
            } else if (b == POINT && !pointSeen) {
                pointSeen = true
            } else {
                break
            }
            at++
        }
        if (count == 0 || at < bytes.size && !isBlank(bytes[at]) || scale < -POWERS.lastIndex) return Double.NaN
        val value = digits / POWERS[-scale]
        return if (negative) -value else value
    }

    /** In binary parts the place is the line where the part begins, and the byte. */
    override fun fail(reason: String): Nothing =
        if (isBinary) failAt(binaryStart - 1, "at byte $wordStart: $reason") else failAt(wordStart, reason)

    private fun failAt(place: Int, reason: String): Nothing {
        var line = 1
        var lineStart = 0
        for (i in 0 until minOf(place, bytes.size)) {
            if (bytes[i] == NEW_LINE) {
                line++
                lineStart = i + 1
            }
        }
        throw FileFormatException(source, line, place - lineStart + 1, reason)
    }

    private fun startWord(what: String) {
        skipBlanks()
        wordStart = at
        if (at >= bytes.size) fail("the file ends where $what should be")
    }

    private fun wholeWord(): String {
        at = wordStart
        return word("")
    }

    /** Skips words up to the next that begins with a letter, or the end. */
    fun skipNumbers() {
        while (!atEnd() && !bytes[at].toInt().toChar().isLetter()) word("")
    }

    private fun skipBlanks() {
        while (at < bytes.size && isBlank(bytes[at])) at++
        if (comment == ' ') return
        while (at < bytes.size && bytes[at] == comment.code.toByte()) {
            while (at < bytes.size && bytes[at] != NEW_LINE) at++
            while (at < bytes.size && isBlank(bytes[at])) at++
        }
    }

    private fun isBlank(b: Byte): Boolean = b.toInt() in 0..BLANK

    private fun isDigit(b: Byte): Boolean = b in ZERO..NINE

    private companion object {
        const val BLANK = ' '.code
        const val NEW_LINE = '\n'.code.toByte()
        const val MINUS = '-'.code.toByte()
        const val PLUS = '+'.code.toByte()
        const val POINT = '.'.code.toByte()
        const val ZERO = '0'.code.toByte()
        const val NINE = '9'.code.toByte()
        const val EXACT_INTEGER = 1L shl 53
        val POWERS = DoubleArray(23) { "1e$it".toDouble() }
    }
}
