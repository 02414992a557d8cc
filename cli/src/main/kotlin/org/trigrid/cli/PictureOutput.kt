package org.trigrid.cli

import picocli.CommandLine
import java.nio.file.Path

internal object PictureOutput {
    fun checkName(file: Path, commandLine: CommandLine) {
        val name = file.fileName.toString().lowercase()
        if (!name.endsWith(".svg") && !name.endsWith(".png")) {
            throw CommandLine.ParameterException(commandLine, "a picture is .svg or .png, not $file")
        }
    }

    fun writeMesh(mesh: org.trigrid.mesh.TriMesh, file: Path) {
        org.trigrid.io.AtomicFile.write(file) { it.write("$mesh".toByteArray()) }
    }
}
