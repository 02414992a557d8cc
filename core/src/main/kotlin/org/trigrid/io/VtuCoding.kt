package org.trigrid.io

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.StringTokenizer
import java.util.zip.DataFormatException
import java.util.zip.Inflater

/** A `DataArray` of a VTK file as it stands there. */
internal class VtuArray(val complaint: Complaint, val type: String, val format: String, val offset: String?) {
    /** What is between its tags; empty for an appended one. */
    var text: String = ""
}

/** How a VTK file holds its numbers, and how to get them out. */
internal class VtuCoding {
    var isBigEndian = false
    var headerBytes = Int.SIZE_BYTES
    var isCompressed = false

    /** Whether appended data are bytes, not base64. */
    var isRaw = false
    var appended: ByteArray? = null
    var appendedStart = 0

    fun numbers(array: VtuArray): DoubleArray {
        val size = typeSize(array)
        if (array.format == "ascii") return asciiNumbers(array)
        val bytes = bytes(sourceOf(array), array.complaint)
        if (bytes.size % size != 0) array.complaint.fail("the data of the array are no whole number of ${array.type}")
        val buffer = ordered(bytes)
        return DoubleArray(bytes.size / size) { number(buffer, it * size, array) }
    }

    private fun asciiNumbers(array: VtuArray): DoubleArray {
        val tokens = StringTokenizer(array.text)
        val values = DoubleArray(tokens.countTokens())
        for (i in values.indices) {
            val word = tokens.nextToken()
            values[i] = RingPoints.decimal(word)
            if (values[i].isNaN()) array.complaint.fail("'$word' is not a number")
        }
        return values
    }

    private fun typeSize(array: VtuArray): Int = when (array.type) {
        "Int8", "UInt8" -> 1
        "Int16", "UInt16" -> 2
        "Int32", "UInt32", "Float32" -> 4
        "Int64", "UInt64", "Float64" -> 8
        else -> array.complaint.fail("arrays of the type '${array.type}' cannot be read")
    }

    private fun number(buffer: ByteBuffer, at: Int, array: VtuArray): Double = when (array.type) {
        "Int8" -> buffer.get(at).toDouble()
        "UInt8" -> (buffer.get(at).toInt() and 0xFF).toDouble()
        "Int16" -> buffer.getShort(at).toDouble()
        "UInt16" -> (buffer.getShort(at).toInt() and 0xFFFF).toDouble()
        "Int32" -> buffer.getInt(at).toDouble()
        "UInt32" -> (buffer.getInt(at).toLong() and 0xFFFFFFFFL).toDouble()
        "Float32" -> buffer.getFloat(at).toDouble()
        "Float64" -> buffer.getDouble(at)
        else -> buffer.getLong(at).toDouble()
    }

    private fun sourceOf(array: VtuArray): ByteSource {
        if (array.format == "binary") return Base64Source(array.text.toByteArray(Charsets.ISO_8859_1), 0, array.complaint)
        if (array.format != "appended") array.complaint.fail("the format '${array.format}' is unknown")
        val data = appended ?: array.complaint.fail("there are no appended data")
        val offset = array.offset?.trim()?.toLongOrNull() ?: array.complaint.fail("the offset is missing")
        if (offset < 0 || offset > data.size - appendedStart) array.complaint.fail("the offset $offset is outside of the appended data")
        val from = appendedStart + offset.toInt()
        return if (isRaw) RawSource(data, from, array.complaint) else Base64Source(data, from, array.complaint)
    }

    private fun bytes(source: ByteSource, complaint: Complaint): ByteArray {
        if (!isCompressed) return source.take(header(source, complaint), complaint)
        val blocks = header(source, complaint)
        header(source, complaint)
        header(source, complaint)
        if (blocks > source.most) complaint.fail("$blocks compressed blocks are more than the file can hold")
        val sizes = LongArray(blocks.toInt()) { header(source, complaint) }
        source.beginAnew()
        val out = ByteArrayOutputStream()
        for (size in sizes) inflate(source.take(size, complaint), out, complaint)
        return out.toByteArray()
    }

    private fun header(source: ByteSource, complaint: Complaint): Long {
        val buffer = ordered(source.take(headerBytes.toLong(), complaint))
        return if (headerBytes == Long.SIZE_BYTES) buffer.getLong(0) else buffer.getInt(0).toLong() and 0xFFFFFFFFL
    }

    private fun inflate(block: ByteArray, out: ByteArrayOutputStream, complaint: Complaint) {
        val inflater = Inflater()
        try {
            inflater.setInput(block)
            val buffer = ByteArray(1 shl 13)
            while (!inflater.finished()) {
                val count = inflater.inflate(buffer)
                if (count == 0) complaint.fail("compressed data end too early")
                out.write(buffer, 0, count)
                val most = MOST_PART * Runtime.getRuntime().maxMemory()
                if (out.size() > most) complaint.fail("Java's heap ends at less than the unpacked data need")
            }
        } catch (_: DataFormatException) {
            complaint.fail("the compressed data are damaged")
        } finally {
            inflater.end()
        }
    }

    private fun ordered(bytes: ByteArray) =
        ByteBuffer.wrap(bytes).order(if (isBigEndian) ByteOrder.BIG_ENDIAN else ByteOrder.LITTLE_ENDIAN)

    private companion object {
        /** Part of the heap that one array may take before its numbers are made of it. */
        const val MOST_PART = 0.1
    }
}

/** Bytes of an array, one after the other. */
internal interface ByteSource {
    /** No more bytes than this can follow. */
    val most: Int

    fun take(count: Long, complaint: Complaint): ByteArray

    /** What follows was encoded for itself. */
    fun beginAnew()
}

private class RawSource(private val data: ByteArray, private var at: Int, private val complaint: Complaint) : ByteSource {
    override val most: Int get() = data.size - at

    override fun take(count: Long, complaint: Complaint): ByteArray {
        if (count < 0 || count > most) this.complaint.fail("the data of the array end too early")
        at += count.toInt()
        return data.copyOfRange(at - count.toInt(), at)
    }

    override fun beginAnew() = Unit
}

/** Base64 in which several encoded parts may follow one another, each with its own padding. */
private class Base64Source(private val text: ByteArray, private var at: Int, private val complaint: Complaint) : ByteSource {
    private val group = ByteArray(3)
    private var groupSize = 0
    private var groupAt = 0

    override val most: Int get() = (text.size - at) / 4 * 3 + 3

    override fun take(count: Long, complaint: Complaint): ByteArray {
        if (count < 0 || count > most) this.complaint.fail("the data of the array end too early")
        val result = ByteArray(count.toInt())
        for (i in result.indices) {
            if (groupAt == groupSize) decodeGroup()
            result[i] = group[groupAt++]
        }
        return result
    }

    override fun beginAnew() {
        groupAt = groupSize
    }

    private fun decodeGroup() {
        var bits = 0
        var count = 0
        var padding = 0
        while (count < 4) {
            while (at < text.size && text[at] in 0..' '.code.toByte()) at++
            if (at == text.size) complaint.fail("the data of the array end too early")
            val c = text[at++].toInt().toChar()
            val value = if (c == '=') 0 else DIGITS.indexOf(c)
            if (value < 0) complaint.fail("'$c' is no character of base64")
            if (c == '=') padding++
            bits = (bits shl 6) or value
            count++
        }
        if (padding > 2) complaint.fail("three = in one group of base64")
        group[0] = (bits shr 16).toByte()
        group[1] = (bits shr 8).toByte()
        group[2] = bits.toByte()
        groupSize = 3 - padding
        groupAt = 0
    }

    private companion object {
        const val DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
    }
}
