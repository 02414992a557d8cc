package org.trigrid.io

import java.io.IOException
import java.io.OutputStream
import java.nio.file.AccessDeniedException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption

/** Writes files beside their place and moves them over it, so that a reader never sees half a file. */
public object AtomicFile {
    /** Writes the bytes of a file. */
    public fun interface Content {
        /** Writes all bytes to [out] and leaves it open. */
        @Throws(IOException::class)
        public fun writeTo(out: OutputStream)
    }

    /**
     * Writes [content] to [path]. If anything fails, what was at [path] is still there and nothing is left beside it.
     * A file that may not be written is refused, a link is followed; what is no ordinary file, such as a pipe or a device, is written to as it is.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(path: Path, content: Content) {
        val place = if (Files.exists(path)) path.toRealPath() else path.toAbsolutePath()
        if (Files.exists(place) && !Files.isRegularFile(place)) {
            naming(path) { Files.newOutputStream(place).use { content.writeTo(it) } }
            return
        }
        if (Files.exists(place) && !Files.isWritable(place)) throw AccessDeniedException(place.toString())
        val draft = createBeside(place)
        try {
            naming(path) { Files.newOutputStream(draft, StandardOpenOption.WRITE).use { content.writeTo(it) } }
            moveOver(draft, place)
        } catch (e: Throwable) {
            Files.deleteIfExists(draft)
            throw e
        }
    }

    /** A full disk, for instance, is told without the name of a file. */
    private fun naming(path: Path, work: () -> Unit) = try {
        work()
    } catch (e: FileSystemException) {
        throw e
    } catch (e: IOException) {
        throw FileSystemException(path.toString(), null, e.message).initCause(e)
    }

    /** An empty file of a new name, with the permissions that new files get. */
    private fun createBeside(place: Path): Path {
        for (n in 0 until TRIES) {
            val draft = place.resolveSibling(".${place.fileName}.$n.tmp")
            try {
                return Files.createFile(draft)
            } catch (_: FileAlreadyExistsException) {
                // Left by a run that was killed, or being written by another.
            }
        }
        throw IOException("no free name for a draft beside $place: remove .${place.fileName}.*.tmp")
    }

    private fun moveOver(draft: Path, place: Path) {
        try {
            Files.move(draft, place, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING)
        } catch (_: AtomicMoveNotSupportedException) {
            Files.move(draft, place, StandardCopyOption.REPLACE_EXISTING)
        }
    }

    private const val TRIES = 1000
}
