package org.trigrid.spark.job

import org.apache.hadoop.conf.Configuration
import org.apache.hadoop.fs.FileStatus
import org.apache.hadoop.fs.Path
import org.trigrid.cli.DomainFileNames
import java.io.FileNotFoundException
import java.io.IOException
import java.io.Serializable

/** A file to be meshed. */
internal class JobFile(
    /** Where it is, on whatever file system. */
    val place: String,
    /** Its name with the folders below the one that was asked for; names its meshes. */
    val relative: String,
    val size: Long,
) : Serializable {
    private companion object {
        private const val serialVersionUID = 1L
    }
}

/** Finds the files that are meant by names, folders and patterns on any file system of Hadoop. */
internal class JobFiles(private val configuration: Configuration) {
    /** In the order of the arguments, those of a folder or pattern by name; each file once. */
    @Throws(IOException::class)
    fun of(arguments: List<String>): List<JobFile> {
        val files = LinkedHashMap<String, JobFile>()
        for (argument in arguments) for (file in expand(argument)) files.putIfAbsent(file.place, file)
        val names = HashMap<String, JobFile>()
        for (file in files.values) {
            val other = names.put(DomainFileNames.withoutEnding(file.relative), file) ?: continue
            throw IllegalArgumentException("${other.place} and ${file.place} would both be meshed to one file")
        }
        require(files.isNotEmpty()) { "there are no files of domains in ${arguments.joinToString(" ")}" }
        return files.values.toList()
    }

    private fun expand(argument: String): List<JobFile> {
        val path = Path(argument)
        val fileSystem = path.getFileSystem(configuration)
        val found = fileSystem.globStatus(path).orEmpty()
        if (found.isEmpty()) throw FileNotFoundException("$argument: no such file or folder")
        return found.sortedBy { it.path }.flatMap { if (it.isDirectory) walk(it.path) else listOf(file(it, it.path.parent)) }
    }

    private fun walk(folder: Path): List<JobFile> {
        val files = ArrayList<FileStatus>()
        val found = folder.getFileSystem(configuration).listFiles(folder, true)
        while (found.hasNext()) found.next().let { if (DomainFileNames.isDomain(it.path.name)) files.add(it) }
        return files.sortedBy { it.path }.map { file(it, folder) }
    }

    private fun file(status: FileStatus, base: Path): JobFile {
        val whole = status.path.toUri().path
        return JobFile(status.path.toString(), whole.removePrefix(base.toUri().path).trimStart('/'), status.len)
    }
}
