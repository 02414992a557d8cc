package org.trigrid.io

import java.io.OutputStream

/** Writes ASCII text and numbers to a stream through one byte buffer, without strings in between. */
internal class TextBuffer(private val out: OutputStream) {
    private val bytes = ByteArray(1 shl 16)
    private var size = 0
    private val decimal = ShortestDecimal()
    private val scratch = ByteArray(20)

    /** Hands everything on to the stream. */
    fun flush() {
        out.write(bytes, 0, size)
        size = 0
        out.flush()
    }

    fun text(ascii: String): TextBuffer {
        for (c in ascii) {
            if (size == bytes.size) spill()
            bytes[size++] = c.code.toByte()
        }
        return this
    }

    /** Text with characters of any kind, in UTF-8. */
    fun utf8(text: String): TextBuffer {
        for (b in text.toByteArray(Charsets.UTF_8)) byte(b.toInt())
        return this
    }

    fun space(): TextBuffer = byte(' '.code)

    fun line(): TextBuffer = byte('\n'.code)

    fun line(ascii: String): TextBuffer = text(ascii).line()

    fun number(value: Int): TextBuffer = number(value.toLong())

    fun number(value: Long): TextBuffer {
        reserve()
        var rest = value
        if (rest < 0) {
            bytes[size++] = MINUS
            if (rest == Long.MIN_VALUE) return text("9223372036854775808")
            rest = -rest
        }
        val count = digitsOf(rest)
        copyDigits(0, count)
        return this
    }

    /** The shortest decimal that reads back as [value], which is finite: 0.5, 12, 1e-9. */
    fun number(value: Double): TextBuffer {
        reserve()
        var positive = value
        if (value < 0) {
            bytes[size++] = MINUS
            positive = -value
        }
        if (positive == 0.0) {
            bytes[size++] = ZERO
            return this
        }
        decimal.of(positive)
        var count = digitsOf(decimal.digits)
        var exponent = decimal.exponent
        while (count > 1 && scratch[count - 1] == ZERO) {
            count--
            exponent++
        }
        // Place of the decimal point after the first digit.
        val point = count + exponent
        if (point in LOWEST_POINT..HIGHEST_POINT) plain(count, point) else scientific(count, point - 1)
        return this
    }

    private fun plain(count: Int, point: Int) {
        if (point <= 0) {
            bytes[size++] = ZERO
            bytes[size++] = POINT
            for (i in point until 0) bytes[size++] = ZERO
            copyDigits(0, count)
        } else if (count <= point) {
            copyDigits(0, count)
            for (i in count until point) bytes[size++] = ZERO
        } else {
            copyDigits(0, point)
            bytes[size++] = POINT
            copyDigits(point, count)
        }
    }

    private fun scientific(count: Int, exponent: Int) {
        bytes[size++] = scratch[0]
        if (count > 1) {
            bytes[size++] = POINT
            copyDigits(1, count)
        }
        bytes[size++] = 'e'.code.toByte()
        number(exponent)
    }

    /** Puts the digits of [value] into [scratch] and returns how many. */
    private fun digitsOf(value: Long): Int {
        var count = 1
        var bound = 10L
        while (count < 19 && value >= bound) {
            bound *= 10
            count++
        }
        var rest = value
        var at = count
        while (at > 1) {
            val next = rest / 100
            val pair = 2 * (rest - 100 * next).toInt()
            scratch[--at] = PAIRS[pair + 1]
            scratch[--at] = PAIRS[pair]
            rest = next
        }
        if (at == 1) scratch[0] = (ZERO + rest.toInt()).toByte()
        return count
    }

    private fun copyDigits(from: Int, to: Int) {
        for (i in from until to) bytes[size++] = scratch[i]
    }

    private fun byte(code: Int): TextBuffer {
        if (size == bytes.size) spill()
        bytes[size++] = code.toByte()
        return this
    }

    private fun reserve() {
        if (size > bytes.size - LONGEST_NUMBER) spill()
    }

    private fun spill() {
        out.write(bytes, 0, size)
        size = 0
    }

    private companion object {
        const val LONGEST_NUMBER = 64
        const val LOWEST_POINT = -4
        const val HIGHEST_POINT = 17
        const val ZERO = '0'.code.toByte()
        const val MINUS = '-'.code.toByte()
        const val POINT = '.'.code.toByte()

        /** 00, 01, …, 99. */
        val PAIRS = ByteArray(200) { ('0'.code + (if (it % 2 == 0) it / 20 else it / 2 % 10)).toByte() }
    }
}
