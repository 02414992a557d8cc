package org.trigrid.cli

import picocli.CommandLine
import picocli.CommandLine.ParameterException
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path

/** Says early that a file cannot be written, before long work. */
internal object OutputPlace {
    @Throws(IOException::class)
    fun check(target: Path) {
        if (target.toString().isEmpty()) throw FileSystemException("''", null, "an empty name is that of no file")
        val folder = target.toAbsolutePath().parent ?: throw FileSystemException(target.toString(), null, A_FOLDER)
        if (!Files.exists(folder)) throw NoSuchFileException(folder.toString())
        if (!Files.isDirectory(folder)) throw NotDirectoryException(folder.toString())
        if (Files.isDirectory(target)) throw FileSystemException(target.toString(), null, A_FOLDER)
        if (!Files.exists(target) && !Files.isWritable(folder)) throw AccessDeniedException(folder.toString())
    }

    /** Two of [files], each under what it is for, that are the same file, links followed, are a usage error: one would be lost. */
    fun checkApart(files: List<Pair<String, Path>>, commandLine: CommandLine) {
        val before = HashMap<Path, Pair<String, Path>>()
        for (file in files) {
            val place = placeOf(file.second)
            // What is no ordinary file, such as a device, holds nothing that can be lost.
            if (Files.exists(place) && !Files.isRegularFile(place)) continue
            val other = before.put(place, file) ?: continue
            throw ParameterException(commandLine, "${file.second} is ${file.first}, but is ${other.first} already")
        }
    }

    /** Where a file is or will be. */
    fun placeOf(file: Path): Path {
        if (Files.exists(file)) return file.toRealPath()
        val absolute = file.toAbsolutePath().normalize()
        val folder = absolute.parent ?: return absolute
        return if (Files.exists(folder)) folder.toRealPath().resolve(absolute.fileName) else absolute
    }

    const val A_FOLDER = "a folder, not a file"
}
