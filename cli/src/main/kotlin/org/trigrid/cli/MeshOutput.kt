package org.trigrid.cli

import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import picocli.CommandLine
import picocli.CommandLine.ParameterException
import java.nio.file.Path

/** In which format a mesh goes to a file. */
object MeshOutput {
    /**
     * That of [name], else of the file's ending, MSH 2.2 for a file without one; anything else is a usage error.
     */
    fun format(name: String?, file: Path?, commandLine: CommandLine): MeshFormat {
        if (name != null) {
            return MeshFormats.named(name)
                ?: throw ParameterException(commandLine, "--format must be one of ${names()}, or 2.2 or 4.1, not $name")
        }
        if (file == null) return MeshFormat.MSH_22
        val found = MeshFormats.forWriting(file)
        val fileName = file.fileName?.toString().orEmpty()
        if (found == null && '.' in fileName.drop(1)) {
            throw ParameterException(commandLine, "the ending of $fileName is none of ${endings()}; choose with --format")
        }
        return found ?: MeshFormat.MSH_22
    }

    fun names(): String = MeshFormats.all().filter { it.canWrite }.joinToString { it.name }

    fun endings(): String = MeshFormats.all().filter { it.canWrite }.flatMap { it.endings.take(2) }.distinct().joinToString(" ")
}
