package org.trigrid.cli

import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.PrintStream
import java.nio.charset.StandardCharsets

/** The two streams of a run, and whether somebody watches the second. */
internal class Terminal(val out: PrintStream, val err: PrintStream, val showsProgress: Boolean) {
    fun flush() {
        out.flush()
        err.flush()
    }

    companion object {
        private const val BUFFER = 1 shl 16

        /** The streams of this process, in UTF-8 whatever the locale, so that reports are the same everywhere. */
        fun ofProcess(): Terminal = Terminal(stream(FileDescriptor.out), stream(FileDescriptor.err), isInteractive())

        private fun stream(descriptor: FileDescriptor): PrintStream {
            val autoFlush = descriptor === FileDescriptor.err
            return PrintStream(FileOutputStream(descriptor).buffered(BUFFER), autoFlush, StandardCharsets.UTF_8)
        }

        /** From Java 22 a console exists also when piped, and says so itself. */
        private fun isInteractive(): Boolean {
            val console = System.console() ?: return false
            val method = runCatching { console.javaClass.getMethod("isTerminal") }.getOrNull() ?: return true
            return runCatching { method.invoke(console) as Boolean }.getOrDefault(true)
        }
    }
}
