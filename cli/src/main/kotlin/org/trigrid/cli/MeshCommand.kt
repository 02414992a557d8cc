package org.trigrid.cli

import org.trigrid.MeshOptions
import org.trigrid.io.AtomicFile
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.picture.Pictures
import org.trigrid.project.DomainInput
import org.trigrid.project.DomainInputs
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Meshes a domain and writes the mesh, and a report and a picture where they are asked for. */
@Command(
    name = "mesh",
    description = ["Mesh a domain and write the mesh as a Gmsh .msh file."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  trigrid mesh plate.trigrid.json -o plate.msh --picture plate.svg",
        "  trigrid mesh coast.geojson -o coast.msh --format 4.1 --sizes grade --report -",
        "  trigrid mesh plate.wkt -o plate.msh --spacing 0.05 --max-size 0.2",
        "",
        "A file with several polygons makes as many meshes: OUT-1.msh, OUT-2.msh, ...",
    ],
)
internal class MeshCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A project (.trigrid.json), GeoJSON, WKT or Triangle .poly file."])
    lateinit var input: Path

    @Option(names = ["-o", "--output"], paramLabel = "OUT.msh", required = true, description = ["The mesh file to write."])
    lateinit var output: Path

    @Option(names = ["--format"], paramLabel = "2.2|4.1", description = ["Version of the .msh format, ASCII. Default: 2.2."])
    var format: String = DEFAULT_FORMAT

    @Mixin
    lateinit var exploding: ExplodingArguments

    @Mixin
    lateinit var meshing: MeshingArguments

    @Option(names = ["--report"], paramLabel = "FILE", description = ["Write figures as JSON; - for standard output."])
    var report: String? = null

    @Option(names = ["--picture"], paramLabel = "FILE", description = ["Draw the mesh; .svg or .png."])
    var picture: Path? = null

    override fun call(): Int {
        val inputOptions = exploding.toOptions(spec.commandLine())
        checkArguments()
        val clock = RunClock()
        val inputs = clock.reading { InputFailure.naming(input) { DomainInputs.read(input, inputOptions) } }
        val figures = inputs.mapIndexed { i, domain -> mesh(domain, i, inputs.size, if (i == 0) clock else RunClock()) }
        writeReport(figures)
        return ExitCodes.DONE
    }

    /** Finds out before the work starts what would only fail after it. */
    private fun checkArguments() {
        meshing.over(MeshOptions.DEFAULT, spec.commandLine())
        meshFormat()
        OutputPlace.check(output)
        picture?.let {
            PictureOutput.checkName(it, spec.commandLine())
            OutputPlace.check(it)
        }
        report?.let { if (it != STANDARD_OUTPUT) OutputPlace.check(Path.of(it)) }
    }

    private fun meshFormat(): MeshFormat = MeshFormat.ofVersion(format)
        ?: throw ParameterException(spec.commandLine(), "--format must be 2.2 or 4.1, not $format")

    private fun mesh(given: DomainInput, index: Int, count: Int, clock: RunClock): MeshFigures {
        val options = meshing.over(given.options, spec.commandLine())
        val result = DomainMesher(session, input).mesh(given.domain, options)
        val file = NumberedFiles.name(output, index, count)
        clock.writing {
            MeshFormats.write(result.mesh, file, meshFormat())
            picture?.let {
                PictureOutput.write(Pictures.mesh(result.mesh), NumberedFiles.name(it, index, count), PictureOutput.DEFAULT_PIXELS)
            }
        }
        val figures = MeshFigures(given.name, result.report, clock)
        if (report != STANDARD_OUTPUT) session.terminal.out.println("$file: ${figures.summary()}")
        return figures
    }

    private fun writeReport(figures: List<MeshFigures>) {
        val target = report ?: return
        val text = ReportJson.text(figures)
        if (target == STANDARD_OUTPUT) session.terminal.out.print(text)
        else AtomicFile.write(Path.of(target)) { it.write(text.toByteArray()) }
    }

    private companion object {
        const val STANDARD_OUTPUT = "-"
        const val DEFAULT_FORMAT = "2.2"
    }
}
