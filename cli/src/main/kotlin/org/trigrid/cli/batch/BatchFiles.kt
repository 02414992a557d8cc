package org.trigrid.cli.batch

import org.trigrid.cli.DomainFileNames
import picocli.CommandLine
import picocli.CommandLine.ParameterException
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.util.regex.PatternSyntaxException
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
        val matcher = try {
            FileSystems.getDefault().getPathMatcher("glob:" + pattern.substring(fixed.length))
        } catch (error: PatternSyntaxException) {
            throw ParameterException(commandLine, "the pattern $pattern makes no sense: ${error.description}")
        }
        val found = walk(base) { matcher.matches(base.relativize(it)) }
        if (found.isEmpty()) throw NoSuchFileException(pattern)
        return found.map { base to it }
    }

    /** Links to folders are not followed, but for the folder itself. */
    private fun walk(folder: Path, accepts: (Path) -> Boolean): List<Path> {
        val real = folder.toRealPath()
        val found = try {
            Files.walk(real).use { files -> files.filter { it.isRegularFile() }.toList() }
        } catch (error: UncheckedIOException) {
            throw error.cause ?: IOException(error)
        }
        return found.map { folder.resolve(real.relativize(it)) }.filter(accepts).sorted()
    }

    private companion object {
        val HERE: Path = Path.of("")
        const val GLOB_SIGNS = "*?[{"
    }
}
