package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale

/**
 * Refuses files that Java's heap cannot hold while they are read, before they are: a file of gigabytes must end in a message.
 *
 * What reading costs is told as a multiple of the file, for the densest file that the format allows.
 */
internal object ReadingMemory {
    /** The text itself, and the bytes it is decoded from. */
    const val TEXT = 3.0
    const val MSH = 8.0
    const val WKT = 30.0
    const val POLY = 60.0

    /** For each value of a JSON text, its key and its place in the value round it. */
    const val JSON_VALUE = 120.0

    /** An array cannot be longer, whatever the heap. */
    private const val LONGEST = Int.MAX_VALUE - 16L

    /** Of the file; packed numbers take more than twice as much when they are unpacked. */
    const val VTU = 16.0

    /** SVG, DXF and `.geo`. */
    const val DRAWING = 100.0

    /** @throws FileFormatException if [multiple] times the size of [file] is more than the heap may hold. */
    @Throws(IOException::class)
    fun check(file: Path, multiple: Double) {
        val size = Files.size(file)
        val reason = refusal(size, multiple * size, Runtime.getRuntime().maxMemory())
        if (reason != null) throw FileFormatException(file.toString(), 0, 0, reason)
    }

    /** @throws FileFormatException if [bytes] are more than the heap may hold; the text has [length] characters. */
    fun check(source: String, length: Int, bytes: Double) {
        val reason = refusal(length.toLong(), bytes, Runtime.getRuntime().maxMemory())
        if (reason != null) throw FileFormatException(source, 0, 0, reason)
    }

    /** Why a file of [size] bytes is not read where [bytes] of memory are needed, or null if it may be. */
    fun refusal(size: Long, bytes: Double, heapBytes: Long): String? = when {
        size > LONGEST -> "a file of ${megabytes(size.toDouble())} MB is too large to be read, whatever the memory"
        bytes > heapBytes ->
            "reading its ${megabytes(size.toDouble())} MB may take ${megabytes(bytes)} MB of memory, but Java's heap ends at " +
                "${megabytes(heapBytes.toDouble())} MB; raise it by Java's option -Xmx (in TRIGRID_JAVA_OPTS for the command trigrid)"
        else -> null
    }

    private fun megabytes(bytes: Double) = "%.0f".format(Locale.ROOT, bytes / 1e6)
}
