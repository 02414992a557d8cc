package org.trigrid.cli

import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.StandardCharsets
import java.util.Locale

/** The two streams of a run, and whether somebody watches the second. */
internal class Terminal(
    val out: PrintStream, val err: PrintStream, val showsProgress: Boolean, private val watched: WatchedOutput? = null,
) {
    fun flush() {
        out.flush()
        err.flush()
    }

    /**
     * Why not all went out that was written to [out], or null. Nothing is wrong when the reader of a pipe has had enough, as
     * `head` has.
     */
    fun trouble(): String? {
        if (!out.checkError()) return null
        val reason = watched?.trouble?.message ?: "cannot be written"
        return if ("pipe" in reason.lowercase(Locale.ROOT)) null else reason
    }

    companion object {
        private const val BUFFER = 1 shl 16

        /** The streams of this process, in UTF-8 whatever the locale, so that reports are the same everywhere. */
        fun ofProcess(): Terminal {
            val watched = WatchedOutput(FileOutputStream(FileDescriptor.out))
            val out = PrintStream(watched.buffered(BUFFER), false, StandardCharsets.UTF_8)
            val err = PrintStream(FileOutputStream(FileDescriptor.err).buffered(BUFFER), true, StandardCharsets.UTF_8)
            return Terminal(out, err, isInteractive(), watched)
        }

        /** From Java 22 a console exists also when piped, and says so itself. */
        private fun isInteractive(): Boolean {
            val console = System.console() ?: return false
            val method = runCatching { console.javaClass.getMethod("isTerminal") }.getOrNull() ?: return true
            return runCatching { method.invoke(console) as Boolean }.getOrDefault(true)
        }
    }
}

/** Remembers the first failure of [out], which a [PrintStream] keeps to itself. */
internal class WatchedOutput(private val out: OutputStream) : OutputStream() {
    var trouble: IOException? = null
        private set

    override fun write(byte: Int) = watching { out.write(byte) }

    override fun write(bytes: ByteArray, start: Int, count: Int) = watching { out.write(bytes, start, count) }

    override fun flush() = watching { out.flush() }

    private fun watching(work: () -> Unit) = try {
        work()
    } catch (error: IOException) {
        if (trouble == null) trouble = error
        throw error
    }
}
