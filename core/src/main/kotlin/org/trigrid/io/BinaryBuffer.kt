package org.trigrid.io

import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Writes little-endian numbers to a stream through one buffer. */
internal class BinaryBuffer(private val out: OutputStream) {
    private val bytes = ByteBuffer.allocate(1 shl 16).order(ByteOrder.LITTLE_ENDIAN)

    fun byte(value: Int): BinaryBuffer {
        room(1).put(value.toByte())
        return this
    }

    fun int(value: Int): BinaryBuffer {
        room(Int.SIZE_BYTES).putInt(value)
        return this
    }

    fun long(value: Long): BinaryBuffer {
        room(Long.SIZE_BYTES).putLong(value)
        return this
    }

    fun long(value: Int): BinaryBuffer = long(value.toLong())

    fun double(value: Double): BinaryBuffer {
        // As in text, where there is no -0.
        room(Double.SIZE_BYTES).putDouble(value + 0.0)
        return this
    }

    fun text(ascii: String): BinaryBuffer {
        for (c in ascii) byte(c.code)
        return this
    }

    fun line(ascii: String): BinaryBuffer = text(ascii).byte('\n'.code)

    /** Hands everything on to the stream. */
    fun flush() {
        spill()
        out.flush()
    }

    private fun room(size: Int): ByteBuffer {
        if (bytes.remaining() < size) spill()
        return bytes
    }

    private fun spill() {
        out.write(bytes.array(), 0, bytes.position())
        bytes.clear()
    }
}
