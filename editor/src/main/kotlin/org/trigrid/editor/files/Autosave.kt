package org.trigrid.editor.files

import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.document.EditorDocument
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.time.Instant
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * Keeps a copy of what is not saved yet beside the file, or in [home] for a drawing without one. The copy is written
 * whole or not at all, and goes when the document is saved or closed. May be used by several threads, and a drawing
 * without a file by several windows: its copy bears the number of the [process] that made it.
 */
internal class Autosave(private val home: Path, private val process: Long = ProcessHandle.current().pid()) {
    private var discards = 0

    /** What [write] must be given: a copy that was asked for before the last [discard] is not wanted any more. */
    val ticket: Int @Synchronized get() = discards

    /** Where the copy of [file] lies. */
    fun copyOf(file: Path?): Path {
        if (file == null) return home.resolve("$UNTITLED$process$ENDING")
        val target = file.toAbsolutePath()
        return target.resolveSibling(".${target.fileName.toString().removeSuffix(DocumentFile.ENDING)}$ENDING")
    }

    @Synchronized
    @Throws(IOException::class)
    fun write(file: Path?, document: EditorDocument, ticket: Int = discards) {
        if (ticket != discards) return
        val copy = copyOf(file)
        Files.createDirectories(copy.toAbsolutePath().parent)
        DocumentFile.write(copy, document)
    }

    /** What a crash left behind for [file], if it is newer than the file; else null. */
    fun recovered(file: Path): EditorDocument? {
        val copy = copyOf(file)
        if (!copy.exists()) return null
        if (file.exists() && copy.getLastModifiedTime() < file.getLastModifiedTime()) return null
        return read(copy)
    }

    /**
     * What a crash left behind of a drawing without a file, the last of several; null if there is none. From then on it is
     * the copy of this process.
     */
    fun adoptUntitled(): EditorDocument? {
        val copies = try {
            if (home.exists()) home.listDirectoryEntries("$UNTITLED*$ENDING") else emptyList()
        } catch (_: IOException) {
            emptyList()
        }
        for (copy in copies.sortedByDescending { it.getLastModifiedTime() }.filter { isLeft(it) }) {
            val document = read(copy)
            try {
                if (document != null) Files.move(copy, copyOf(null), StandardCopyOption.REPLACE_EXISTING) else Files.delete(copy)
            } catch (_: IOException) {
                // It stays where it is and is offered once more.
            }
            if (document != null) return document
        }
        return null
    }

    @Synchronized
    fun discard(file: Path?) {
        discards++
        try {
            Files.deleteIfExists(copyOf(file))
        } catch (_: IOException) {
            // A copy that cannot be removed is only offered once more.
        }
    }

    /** Whether the process that made [copy] is gone; a process of its number that began later is another one. */
    private fun isLeft(copy: Path): Boolean {
        val number = copy.name.removePrefix(UNTITLED).removeSuffix(ENDING).toLongOrNull() ?: return true
        if (number == process) return false
        val start: Instant? = ProcessHandle.of(number).filter { it.isAlive }.map { it.info().startInstant().orElse(Instant.MIN) }.orElse(null)
        return start == null || start > copy.getLastModifiedTime().toInstant()
    }

    private fun read(copy: Path): EditorDocument? = try {
        DocumentFile.read(copy).document
    } catch (_: IOException) {
        null
    } catch (_: TriGridException) {
        null
    }

    private companion object {
        const val UNTITLED = "untitled-"
        const val ENDING = ".autosave${DocumentFile.ENDING}"
    }
}
