package org.trigrid.spark.job

import org.apache.hadoop.fs.Path
import org.apache.spark.api.java.function.Function
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.util.SerializableConfiguration
import org.trigrid.io.DomainFormats
import org.trigrid.project.DomainInputs
import org.trigrid.spark.Outline
import org.trigrid.spark.OutlineDomains
import java.io.IOException

/** Reads files on the machines of the cluster; one that cannot be read is an outline with trouble. */
internal class FileReading(private val configuration: Broadcast<SerializableConfiguration>) : Function<JobFile, Outline> {
    override fun call(file: JobFile): Outline {
        val local = java.nio.file.Path.of(file.relative)
        val name = local.fileName.toString()
        val format = if (DomainInputs.isProject(local)) OutlineDomains.PROJECT else DomainFormats.forFile(local)?.name
        val baseName = if (format == OutlineDomains.PROJECT) name.dropLast(PROJECT_ENDING) else name.substringBefore('.').ifEmpty { "domain" }
        return try {
            val path = Path(file.place)
            val content = PlainFiles.systemOf(path, configuration.value().value()).open(path).use { it.readAllBytes() }
            Outline(file.relative, baseName, format, content)
        } catch (error: IOException) {
            Outline(file.relative, baseName, format, ByteArray(0), error.message ?: error.toString())
        }
    }

    private companion object {
        private const val serialVersionUID = 1L
        private const val PROJECT_ENDING = ".trigrid.json".length
    }
}
