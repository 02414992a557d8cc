package org.trigrid.editor.files

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.document.EditorDocument
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime

/**
 * Keeps a copy of what is not saved yet beside the file, or in [home] for a drawing without one. The copy is written
 * whole or not at all, and goes when the document is saved or closed.
 */
internal class Autosave(private val home: Path) {
    /** Where the copy of [file] lies. */
    fun copyOf(file: Path?): Path {
        if (file == null) return home.resolve("untitled.autosave${DocumentFile.ENDING}")
        val target = file.toAbsolutePath()
        return target.resolveSibling(".${target.fileName.toString().removeSuffix(DocumentFile.ENDING)}.autosave${DocumentFile.ENDING}")
    }

    @Throws(IOException::class)
    fun write(file: Path?, document: EditorDocument) {
        val copy = copyOf(file)
        Files.createDirectories(copy.toAbsolutePath().parent)
        DocumentFile.write(copy, document)
    }

    /** What a crash left behind for [file], if it is newer than the file; else null. */
    fun recovered(file: Path?): EditorDocument? {
        val copy = copyOf(file)
        if (!copy.exists()) return null
        if (file != null && file.exists() && copy.getLastModifiedTime() < file.getLastModifiedTime()) return null
        return try {
            DocumentFile.read(copy).document
        } catch (_: IOException) {
            null
        } catch (_: TriGridException) {
            null
        }
    }

    fun discard(file: Path?) {
        try {
            Files.deleteIfExists(copyOf(file))
        } catch (_: IOException) {
            // A copy that cannot be removed is only offered once more.
        }
    }
}
