package org.trigrid.diagnostics

/** What TriGrid throws when an input cannot be meshed or read; unchecked, one family. */
public sealed class TriGridException(message: String, cause: Throwable? = null) : RuntimeException(message, cause)

/** The domain has faults; nothing was meshed. */
public class InvalidDomainException(faults: List<Fault>) :
    TriGridException(summary(faults)) {
    /** All faults found, in the order of their first nodes. */
    @get:JvmName("faults")
    public val faults: List<Fault> = java.util.List.copyOf(faults)

    private companion object {
        fun summary(faults: List<Fault>): String {
            val first = faults.firstOrNull()?.toString() ?: "unknown fault"
            return if (faults.size <= 1) first else "${faults.size} faults, the first: $first"
        }
    }
}

/** A shape cannot be exploded as asked; the message names the shape and the field. */
public class InvalidShapeException(message: String) : TriGridException(message)

/** The user cancelled through a [ProgressMonitor]. */
public class MeshingCancelledException : TriGridException("meshing was cancelled")

/** The mesh would need more elements than allowed, or the front made more than its work budget. */
public class TooManyElementsException(message: String) : TriGridException(message)

/**
 * The text of a file is not what its format asks for.
 *
 * @param line 1-based line, or 0 where a line makes no sense.
 * @param column 1-based column, or 0 where it is not known.
 */
public class FileFormatException(
    @get:JvmName("source") public val source: String,
    @get:JvmName("line") public val line: Int,
    @get:JvmName("column") public val column: Int,
    reason: String,
    cause: Throwable? = null,
) : TriGridException(place(source, line, column) + shortened(reason), cause) {
    private companion object {
        const val LONGEST = 400
        const val SHOWN_END = 100

        fun place(source: String, line: Int, column: Int): String = buildString {
            append(source)
            if (line > 0) append(':').append(line)
            if (line > 0 && column > 0) append(':').append(column)
            append(": ")
        }

        /** A word of the file in the middle may be the whole file. */
        fun shortened(reason: String): String =
            if (reason.length <= LONGEST) reason else reason.take(LONGEST - SHOWN_END) + "…" + reason.takeLast(SHOWN_END)
    }
}
