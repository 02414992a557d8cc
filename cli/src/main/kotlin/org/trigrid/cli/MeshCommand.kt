package org.trigrid.cli

import org.trigrid.MeshOptions
import org.trigrid.cli.batch.BatchFiles
import org.trigrid.cli.batch.BatchLog
import org.trigrid.cli.batch.BatchPlan
import org.trigrid.cli.batch.BatchRun
import org.trigrid.cli.batch.MadeMeshes
import org.trigrid.io.AtomicFile
import org.trigrid.io.MeshFormat
import org.trigrid.mesh.TriMesh
import org.trigrid.picture.Pictures
import org.trigrid.project.DomainInput
import org.trigrid.project.DomainInputs
import org.trigrid.project.InputOptions
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable

/** Meshes a domain and writes the mesh, and a report and a picture where they are asked for. */
@Command(
    name = "mesh",
    description = ["Mesh a domain and write the mesh; or with --out-dir those of many files."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  trigrid mesh plate.trigrid.json -o plate.msh --picture plate.svg",
        "  trigrid mesh coast.geojson -o coast.msh --format msh41 --sizes grade --report -",
        "  trigrid mesh disc.trigrid.json -o disc.inp --order 2",
        "  trigrid mesh plate.wkt -o plate.vtu --spacing 0.05 --max-size 0.2",
        "  trigrid mesh plate.wkt -o plate.msh --size-source 0.01@0.5,0.4 --size-source 0.05@1,0,1,1",
        "  trigrid mesh motor.dxf -o motor.msh --region iron=1@0,9 --region copper=2,0.5@4,3,-4,3 --point probe@1,1",
        "  trigrid mesh soils.geojson -o soils.vtu --join-domains --line drain,0.5@2,3,8,3",
        "  trigrid mesh outlines 'more/*.dxf' --out-dir meshes --report meshes/report.jsonl --resume",
        "",
        "A file with several polygons makes as many meshes: OUT-1.msh, OUT-2.msh, ...",
    ],
)
internal class MeshCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(
        paramLabel = "IN", arity = "1..*",
        description = [
            "A project (.trigrid.json), GeoJSON, WKT, TopoJSON, SVG, DXF, Gmsh .geo, Triangle .poly or a table of points; with " +
                "--out-dir any number of files, folders and patterns.",
        ],
    )
    lateinit var inputs: List<String>

    @Option(names = ["-o", "--output"], paramLabel = "OUT", description = ["The mesh file to write; its ending tells the format."])
    var output: Path? = null

    @Option(
        names = ["--format"], paramLabel = "NAME",
        description = ["Another format than the ending tells; 'trigrid convert --list' names them. Default without one: msh22."],
    )
    var format: String? = null

    @Option(names = ["--out-dir"], paramLabel = "DIR", description = ["Mesh many files, into this folder; go on when one fails."])
    var outDir: Path? = null

    @Option(names = ["--jobs"], paramLabel = "N", description = ["With --out-dir: meshes made at a time. Default: as many as processors."])
    var jobs: Int? = null

    @Option(names = ["--resume"], description = ["With --out-dir and --report: leave meshes that the report has, of the same input and options, and add to it."])
    var resume: Boolean = false

    @Mixin
    lateinit var exploding: ExplodingArguments

    @Mixin
    lateinit var inner: InnerArguments

    @Mixin
    lateinit var ordering: OrderArguments

    @Mixin
    lateinit var meshing: MeshingArguments

    @Option(
        names = ["--report"], paramLabel = "FILE",
        description = ["Write figures as JSON, with --out-dir one line a mesh; - for standard output."],
    )
    var report: String? = null

    @Option(names = ["--picture"], paramLabel = "FILE", description = ["Draw the mesh; .svg or .png."])
    var picture: Path? = null

    override fun call(): Int {
        val inputOptions = inner.over(exploding.toOptions(spec.commandLine()), spec.commandLine())
        meshing.over(MeshOptions.DEFAULT, spec.commandLine())
        outDir?.let { return meshMany(it, inputOptions) }
        val target = output ?: usage("say where the mesh goes: --output OUT, or --out-dir DIR for many")
        if (jobs != null || resume) usage("--jobs and --resume are for --out-dir")
        val input = Path.of(inputs.singleOrNull() ?: usage("several files need --out-dir, not --output"))
        if (Files.isDirectory(input) && input.toString().isNotEmpty()) usage("$input is a folder; with --out-dir all its files are meshed")
        if (target.toString() == STANDARD_OUTPUT) usage("meshes are written to files, not to standard output; give a name to --output")
        val meshFormat = MeshOutput.format(format, target, spec.commandLine())
        ordering.check(meshFormat, spec.commandLine())
        checkPlaces(input, target, meshFormat)
        val clock = RunClock()
        val domains = clock.reading { InputFailure.naming(input) { DomainInputs.read(input, inputOptions) } }
        val figures = domains.mapIndexed { i, domain ->
            val file = NumberedFiles.name(target, i, domains.size)
            val drawn = picture?.let { NumberedFiles.name(it, i, domains.size) }
            mesh(input, domain, ordering.of(domain, meshFormat), if (i == 0) clock else RunClock()) { mesh, ordered ->
                ordered.write(file, meshFormat)
                drawn?.let { PictureOutput.write(Pictures.mesh(mesh), it, PictureOutput.DEFAULT_PIXELS) }
            }.also { if (report != STANDARD_OUTPUT) session.terminal.out.println(OneLine.of("$file: ${it.summary()}")) }
        }
        writeReport(figures)
        return ExitCodes.DONE
    }

    private fun usage(message: String): Nothing = throw ParameterException(spec.commandLine(), message)

    /** Finds out before the work starts what would only fail after it. */
    private fun checkPlaces(input: Path, target: Path, meshFormat: MeshFormat) {
        OutputPlace.check(target)
        val written = meshFormat.filesOf(target).map { "the mesh" to it } +
            listOfNotNull(picture?.let { "the picture" to it }, report?.takeIf { it != STANDARD_OUTPUT }?.let { "the report" to Path.of(it) })
        OutputPlace.checkApart(listOf("the input" to input) + written, spec.commandLine())
        picture?.let {
            PictureOutput.checkName(it, spec.commandLine())
            OutputPlace.check(it)
        }
        report?.let { if (it != STANDARD_OUTPUT) OutputPlace.check(Path.of(it)) }
    }

    private fun meshMany(folder: Path, inputOptions: InputOptions): Int {
        if (output != null) usage("--output is for one file, --out-dir for many")
        if (picture != null) usage("--picture is for one file; 'trigrid picture' draws the meshes afterwards")
        if (folder.toString().isEmpty() || inputs.any { it.isEmpty() }) usage("an empty name is that of no file or folder")
        val threads = jobs ?: Runtime.getRuntime().availableProcessors()
        if (threads !in 1..MOST_JOBS) usage("--jobs must be from 1 to $MOST_JOBS, not $threads")
        val remembered = report?.takeIf { it != STANDARD_OUTPUT }?.let { Path.of(it) }
        if (resume && remembered == null) usage("--resume needs --report FILE, which remembers of what each mesh was made")
        val meshFormat = MeshOutput.format(format, null, spec.commandLine())
        ordering.check(meshFormat, spec.commandLine())
        val files = BatchFiles(folder, meshFormat.endings[0], spec.commandLine()).of(inputs)
        Files.createDirectories(folder)
        remembered?.let { file ->
            OutputPlace.check(file)
            OutputPlace.checkApart(files.map { "an input" to it.input } + ("the report" to file), spec.commandLine())
        }
        val made = if (resume && remembered != null) MadeMeshes.of(remembered) else MadeMeshes.NONE
        val plan = BatchPlan(inputOptions, meshFormat, ordering, threads, made) { meshing.over(it, spec.commandLine()) }
        BatchLog.open(report, session.terminal.out, resume).use { log ->
            val batch = BatchRun(session, plan, files, log)
            val code = batch.run()
            if (report != STANDARD_OUTPUT) session.terminal.out.println("$folder: ${batch.summary()}")
            if (code == ExitCodes.CANCELLED) session.terminal.err.println("$folder: cancelled" + if (remembered == null) "" else "; --resume goes on")
            return code
        }
    }

    private fun mesh(
        input: Path, given: DomainInput, order: Int, clock: RunClock, write: (TriMesh, OrderedMesh) -> Unit,
    ): MeshFigures {
        val options = meshing.over(given.options, spec.commandLine())
        val result = DomainMesher(session, input).mesh(given.domain, options)
        val ordered = clock.ordering { OrderedMesh.of(result.mesh, order, options.numbering, given::middles) }
        clock.writing { write(result.mesh, ordered) }
        return MeshFigures(given.name, result.report, clock, ordered.quadratic)
    }

    private fun writeReport(figures: List<MeshFigures>) {
        val target = report ?: return
        val text = ReportJson.text(figures)
        if (target == STANDARD_OUTPUT) session.terminal.out.print(text)
        else AtomicFile.write(Path.of(target)) { it.write(text.toByteArray()) }
    }

    private companion object {
        const val STANDARD_OUTPUT = "-"
        const val MOST_JOBS = 1024
    }
}
