package org.trigrid.cli

import java.io.IOException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING

/** Writes a file beside its place and moves it over, so that a reader sees the old or the new one, never a part. */
internal object ReplacingFile {
    /** Says early that [target] cannot be written, before hours of work. */
    @Throws(IOException::class)
    fun checkPlace(target: Path) {
        val folder = folderOf(target)
        if (!Files.exists(folder)) throw NoSuchFileException(folder.toString())
        if (!Files.isDirectory(folder)) throw NotDirectoryException(folder.toString())
        if (Files.isDirectory(target)) throw IOException("$target is a folder")
    }

    /** Has [write] write a file of the same extension, then puts it in the place of [target]. */
    @Throws(IOException::class)
    fun write(target: Path, write: (Path) -> Unit) {
        checkPlace(target)
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            // A pipe or a device can't be replaced.
            write(target)
            return
        }
        val place = if (Files.exists(target)) target.toRealPath() else target.toAbsolutePath()
        val beside = place.resolveSibling(".trigrid-${ProcessHandle.current().pid()}-${place.fileName}")
        try {
            write(beside)
            try {
                Files.move(beside, place, ATOMIC_MOVE, REPLACE_EXISTING)
            } catch (_: AtomicMoveNotSupportedException) {
                Files.move(beside, place, REPLACE_EXISTING)
            }
        } finally {
            Files.deleteIfExists(beside)
        }
    }

    private fun folderOf(target: Path): Path = target.toAbsolutePath().parent ?: throw IOException("$target is a folder")
}
