package org.trigrid.cli

import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import picocli.CommandLine
import picocli.CommandLine.Option
import java.nio.file.Path

/** Where a reworked mesh goes. */
internal class MeshOutputArguments {
    @Option(
        names = ["-o", "--output"], paramLabel = "OUT", required = true,
        description = ["The mesh file to write; its ending tells the format."],
    )
    lateinit var output: Path

    @Option(
        names = ["--format"], paramLabel = "NAME",
        description = ["Another format than the ending tells; 'trigrid convert --list' names them."],
    )
    var format: String? = null

    /** Finds out before the work what would only fail after it. */
    fun check(commandLine: CommandLine): MeshFormat {
        val found = MeshOutput.format(format, output, commandLine)
        OutputPlace.check(output)
        return found
    }

    fun write(mesh: TriMesh, commandLine: CommandLine): Unit =
        MeshFormats.write(mesh, output, MeshOutput.format(format, output, commandLine))

    fun write(mesh: QuadraticMesh, commandLine: CommandLine): Unit =
        MeshFormats.write(mesh, output, MeshOutput.format(format, output, commandLine))
}

/** Reads meshes that must be valid to be worked on. */
internal class ValidMesh(private val session: Session) {
    /** Null if the mesh of [file] is not valid; the violations are printed. */
    fun read(file: Path): TriMesh? {
        val mesh = MeshInput.read(file)
        val violations = MeshCheck.check(mesh)
        for (it in violations) session.terminal.err.println("$file: ${it.kind} at (${it.x}, ${it.y}): ${it.message}")
        return mesh.takeIf { violations.isEmpty() }
    }
}
