package org.trigrid.cli.batch

import org.trigrid.cli.DomainFileNames
import picocli.CommandLine
import picocli.CommandLine.ParameterException
import java.io.IOException
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile

/** Finds the files that are meant by names, folders and patterns, and names their meshes. */
internal class BatchFiles(private val folder: Path, private val ending: String, private val commandLine: CommandLine) {
    /** In the order of the arguments, those of a folder or pattern by name; each file once. */
    @Throws(IOException::class)
    fun of(arguments: List<String>): List<BatchFile> {
        val files = LinkedHashMap<Path, BatchFile>()
        val outputs = HashMap<Path, Path>()
        for (argument in arguments) {
            for ((base, file) in expand(argument)) {
                if (file in files) continue
                val output = folder.resolve(DomainFileNames.withoutEnding(base.relativize(file).toString()) + ending)
                outputs.put(output, file)?.let {
                    throw ParameterException(commandLine, "$it and $file would both be meshed to $output")
                }
                files[file] = BatchFile(file, output)
            }
        }
        if (files.isEmpty()) throw ParameterException(commandLine, "there are no files of domains in ${arguments.joinToString(" ")}")
        return files.values.toList()
    }

    /** Files with the folder that their names in the output folder are relative to. */
    private fun expand(argument: String): List<Pair<Path, Path>> {
        val path = Path.of(argument)
        return when {
            path.isDirectory() -> walk(path) { DomainFileNames.isDomain(it.fileName.toString()) }.map { path to it }
            Files.exists(path) -> listOf((path.parent ?: HERE) to path)
            argument.any { it in GLOB_SIGNS } -> matching(argument)
            else -> throw NoSuchFileException(argument)
        }
    }

    private fun matching(pattern: String): List<Pair<Path, Path>> {
        val start = pattern.indexOfFirst { it in GLOB_SIGNS }
        val fixed = pattern.substring(0, pattern.lastIndexOf('/', start) + 1)
        val base = if (fixed.isEmpty()) HERE else Path.of(fixed)
        if (!base.isDirectory()) throw NoSuchFileException(base.toString())
        val matcher = FileSystems.getDefault().getPathMatcher("glob:" + pattern.substring(fixed.length))
        val found = walk(base) { matcher.matches(base.relativize(it)) }
        if (found.isEmpty()) throw NoSuchFileException(pattern)
        return found.map { base to it }
    }

    private fun walk(folder: Path, accepts: (Path) -> Boolean): List<Path> =
        Files.walk(folder).use { files -> files.filter { it.isRegularFile() && accepts(it) }.sorted().toList() }

    private companion object {
        val HERE: Path = Path.of("")
        const val GLOB_SIGNS = "*?[{"
    }
}
