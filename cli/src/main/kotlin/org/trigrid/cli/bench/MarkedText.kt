package org.trigrid.cli.bench

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Measurements inside a document: between two marks, so that what is written by hand round them stays when they are made
 * again. A file without marks, or none yet, becomes the measurements alone, marks included.
 */
internal object MarkedText {
    private const val BEGIN = "<!-- measured: begin -->"
    private const val END = "<!-- measured: end -->"

    fun write(file: Path, text: String) {
        val old = if (file.exists()) file.readText() else ""
        file.writeText(replaced(old, text))
    }

    fun replaced(old: String, text: String): String {
        val marked = "$BEGIN\n\n${text.trim()}\n\n$END"
        val begin = old.indexOf(BEGIN)
        val end = old.indexOf(END)
        return if (begin < 0 || end < begin) "$marked\n" else old.substring(0, begin) + marked + old.substring(end + END.length)
    }
}
