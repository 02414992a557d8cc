package org.trigrid.io

import java.nio.file.Path
import java.util.Locale

/** A file format as users meet it: by its short name, or by the ending of a file's name. */
public sealed class FileFormat(
    /** Short name, as after `--format`: `msh22`, `vtu`. */
    @get:JvmName("name") public val name: String,
    /** What people call it, with its version. */
    @get:JvmName("title") public val title: String,
    /** Endings of file names with their dots, in lower case; the first is the usual one. Several formats may share one. */
    @get:JvmName("endings") public val endings: List<String>,
    /** Whether files of the format can be read. */
    @get:JvmName("canRead") public val canRead: Boolean,
    /** Whether files of the format can be written. */
    @get:JvmName("canWrite") public val canWrite: Boolean,
) {
    /** Whether the name of [file] has one of the endings, in upper or lower case. */
    public fun fits(file: Path): Boolean = endingOf(file) != null

    /** The ending that the name of [file] has, the longest of several, or null. */
    internal fun endingOf(file: Path): String? {
        val fileName = file.fileName?.toString()?.lowercase(Locale.ROOT) ?: return null
        return endings.filter { fileName.endsWith(it) }.maxByOrNull { it.length }
    }

    /** The file beside [file] that has [ending] in the place of its own. */
    internal fun sibling(file: Path, ending: String): Path {
        val fileName = file.fileName.toString()
        return file.resolveSibling(fileName.dropLast(endingOf(file)?.length ?: 0) + ending)
    }

    override fun toString(): String = "$name ($title)"
}
