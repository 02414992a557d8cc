package org.trigrid.spark.job

import org.apache.hadoop.fs.FileSystem
import org.apache.hadoop.fs.Path
import org.apache.spark.TaskContext
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructField
import org.apache.spark.util.SerializableConfiguration
import org.trigrid.cli.DomainFileNames
import org.trigrid.cli.NumberedFiles
import org.trigrid.io.MeshFormats
import org.trigrid.spark.MadeMesh
import org.trigrid.spark.MeshRow
import org.trigrid.spark.MeshSink
import org.trigrid.spark.Outline
import java.io.IOException
import java.nio.file.Path as LocalPath

/**
 * Writes each mesh to a file of its own below [folder], on any file system of Hadoop, under the name that the command line gives it.
 * A file is written beside its place and moved there, so that none is seen half done; a task that is run twice writes the same.
 */
internal class FilesSink(
    private val folder: String, private val formatName: String, private val configuration: Broadcast<SerializableConfiguration>,
) : MeshSink {
    override val columns: List<StructField>
        get() = listOf(DataTypes.createStructField(OUTPUT, DataTypes.StringType, true), DataTypes.createStructField(BYTES, DataTypes.LongType, true))

    override fun put(row: MeshRow, outline: Outline, domain: Int, domainCount: Int, mesh: MadeMesh) {
        val format = requireNotNull(MeshFormats.named(formatName))
        val single = LocalPath.of(DomainFileNames.withoutEnding(outline.id) + format.endings[0])
        val target = child(Path(folder), NumberedFiles.name(single, domain, domainCount))
        val attempt = TaskContext.get()?.taskAttemptId() ?: 0
        val draft = Path(target.parent, Path(null, null, ".${target.name}.$attempt"))
        val fileSystem = PlainFiles.systemOf(draft, configuration.value().value())
        fileSystem.mkdirs(target.parent)
        try {
            fileSystem.create(draft, true).use { mesh.write(it, format) }
            row.set(BYTES, fileSystem.getFileStatus(draft).len)
            move(fileSystem, draft, target)
        } finally {
            fileSystem.delete(draft, false)
        }
        row.set(OUTPUT, target.toString())
    }

    private fun move(fileSystem: FileSystem, draft: Path, target: Path) {
        fileSystem.delete(target, false)
        if (!fileSystem.rename(draft, target)) throw IOException("$draft cannot be moved to $target")
    }

    /** Names may hold what Hadoop takes for the sign of a scheme. */
    private fun child(parent: Path, relative: LocalPath): Path = relative.fold(parent) { at, name -> Path(at, Path(null, null, name.toString())) }

    companion object {
        private const val serialVersionUID = 1L

        /** Where the mesh's file is. */
        const val OUTPUT = "output"

        /** Its size. */
        const val BYTES = "bytes"
    }
}
