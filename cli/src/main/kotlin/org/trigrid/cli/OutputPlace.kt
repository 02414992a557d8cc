package org.trigrid.cli

import java.io.IOException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path

/** Says early that a file cannot be written, before long work. */
internal object OutputPlace {
    @Throws(IOException::class)
    fun check(target: Path) {
        val folder = target.toAbsolutePath().parent ?: throw IOException("$target is a folder")
        if (!Files.exists(folder)) throw NoSuchFileException(folder.toString())
        if (!Files.isDirectory(folder)) throw NotDirectoryException(folder.toString())
        if (Files.isDirectory(target)) throw IOException("$target is a folder")
    }
}
