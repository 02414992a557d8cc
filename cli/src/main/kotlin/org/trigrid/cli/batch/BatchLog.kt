package org.trigrid.cli.batch

import java.io.Closeable
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.io.RandomAccessFile
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption

/** The report of a batch: one JSON object a line, each there as soon as its mesh is. Used by several threads. */
internal class BatchLog private constructor(private val out: OutputStream?, private val name: String, private val closes: Boolean) : Closeable {
    @Synchronized
    @Throws(IOException::class)
    fun write(line: String) {
        val stream = out ?: return
        try {
            stream.write((line + "\n").toByteArray())
            stream.flush()
        } catch (error: IOException) {
            throw FileSystemException(name, null, error.message).initCause(error)
        }
    }

    override fun close() {
        if (closes) out?.close()
    }

    companion object {
        /** @param target a file, `-` for [standard], or null for none; [appends] keeps the lines that are there. */
        @Throws(IOException::class)
        fun open(target: String?, standard: PrintStream, appends: Boolean): BatchLog = when (target) {
            null -> BatchLog(null, "", false)
            "-" -> BatchLog(standard, "standard output", false)
            else -> {
                val continues = appends && !endsWithLine(Path.of(target))
                val mode = if (appends) StandardOpenOption.APPEND else StandardOpenOption.TRUNCATE_EXISTING
                val file = Files.newOutputStream(Path.of(target), StandardOpenOption.CREATE, StandardOpenOption.WRITE, mode)
                BatchLog(file, target, true).also { if (continues) it.write("") }
            }
        }

        /** A run that was killed may have left a part of one. */
        private fun endsWithLine(file: Path): Boolean {
            if (!Files.isRegularFile(file)) return true
            RandomAccessFile(file.toFile(), "r").use {
                if (it.length() == 0L) return true
                it.seek(it.length() - 1)
                return it.read() == '\n'.code
            }
        }
    }
}
