package org.trigrid.cli

import org.trigrid.MeshOptions
import org.trigrid.cli.bench.BenchmarkFamily
import org.trigrid.cli.bench.Machine
import org.trigrid.cli.bench.MarkedText
import org.trigrid.cli.bench.PeerProgram
import org.trigrid.cli.bench.QualityBenchmark
import org.trigrid.cli.bench.QualityTables
import org.trigrid.cli.bench.SpeedBenchmark
import org.trigrid.cli.bench.SpeedTables
import org.trigrid.project.DomainInput
import org.trigrid.project.DomainInputs
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile

/** Measures speed or quality, ours alone or beside that of other mesh generators. */
@Command(
    name = "bench",
    description = [
        "Measure how fast TriGrid meshes, warm and in this process, or with --quality how good its meshes are; with " +
            "--compare beside Gmsh, Netgen and Triangle.",
    ],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "The peers are run by python3, or the Python that TRIGRID_PYTHON names; those without a package are left out.",
        "",
        "Examples:",
        "  trigrid bench --sizes 1e4,1e5 --domains square,coast",
        "  trigrid bench --compare --markdown docs/performance.md",
        "  trigrid bench --quality benchmarks/domains --compare --markdown docs/quality.md",
    ],
)
internal class BenchCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Option(names = ["--sizes"], paramLabel = "N", split = ",", description = ["Numbers of elements. Default: 1e3,1e4,1e5."])
    var sizes: List<Double> = listOf(1e3, 1e4, 1e5)

    @Option(
        names = ["--domains"], paramLabel = "NAME", split = ",",
        description = [
            "square, circle, annulus, airfoil, plate (200 holes), coast, hole (1 hole), sieve (10,000 holes). Default: the " +
                "first six.",
        ],
    )
    var families: List<BenchmarkFamily> = BenchmarkFamily.entries - BenchmarkFamily.HOLE - BenchmarkFamily.SIEVE

    @Option(
        names = ["--threads"], paramLabel = "N",
        description = ["Threads that share our work. From 2 on our times are those of the clock, not of a processor. Default: 1."],
    )
    var threads: Int = 1

    @Option(names = ["--runs"], paramLabel = "N", description = ["Runs of each domain. Default: 5."])
    var runs: Int = 5

    @Option(
        names = ["--warm-up"], paramLabel = "SECONDS", description = ["Meshing before anything is measured. Default: 15."],
    )
    var warmUp: Double = 15.0

    @Option(
        names = ["--quality"], paramLabel = "PATH", arity = "1..*",
        description = ["Measure the quality of the meshes of these domain files, or folders of them, instead of the speed."],
    )
    var quality: List<Path> = emptyList()

    @Option(names = ["--compare"], description = ["Run the peers that are installed as well."])
    var compare: Boolean = false

    @Option(
        names = ["--peer-limit"], paramLabel = "SECONDS",
        description = ["A peer that takes longer for one domain is stopped. Default: 1200."],
    )
    var peerLimit: Long = 1200

    @Option(
        names = ["--markdown"], paramLabel = "FILE",
        description = ["Write the tables there, between the marks of an earlier run, or as a new file. Default: print them."],
    )
    var markdown: Path? = null

    override fun call(): Int {
        if (runs < 1) throw ParameterException(spec.commandLine(), "--runs must be at least 1, not $runs")
        if (threads < 1) throw ParameterException(spec.commandLine(), "--threads must be at least 1, not $threads")
        sizes.firstOrNull { !(it >= 1 && it <= MOST) }
            ?.let { throw ParameterException(spec.commandLine(), "--sizes must be from 1 to 1e8, not $it") }
        val options = MeshOptions.builder().maxElements(Int.MAX_VALUE).threads(threads).build()
        val tables = if (compare) {
            PeerProgram(System.getenv("TRIGRID_PYTHON") ?: "python3", peerLimit).use { tables(options, it) }
        } else {
            tables(options, null)
        }
        val text = heading() + "\n\n" + tables
        markdown?.let { MarkedText.write(it, text) } ?: session.terminal.out.println(text)
        return ExitCodes.DONE
    }

    private fun tables(options: MeshOptions, peers: PeerProgram?): String {
        val versions = peers?.versions.orEmpty()
        if (peers != null && versions.isEmpty()) tell("no peer is installed for the Python in use")
        if (quality.isNotEmpty()) return QualityTables(QualityBenchmark(peers, ::tell).measure(domains())).text()
        val benchmark = SpeedBenchmark(options, runs, peers, ::tell)
        benchmark.warmUp(warmUp)
        return SpeedTables(families.flatMap { family -> sizes.map { benchmark.measure(family, it) } }, versions).text()
    }

    private fun heading(): String {
        val arguments = spec.commandLine().parent.parseResult.originalArgs()
        return "`trigrid ${arguments.joinToString(" ")}` on ${Machine.describe()}."
    }

    private fun domains(): List<DomainInput> = quality.flatMap { filesOf(it) }
        .flatMap { file -> InputFailure.naming(file) { DomainInputs.read(file) } }

    private fun filesOf(path: Path): List<Path> = if (!path.isDirectory()) {
        listOf(path)
    } else {
        Files.list(path).use { files ->
            files.filter { it.isRegularFile() && isDomainFile(it.fileName.toString()) }.sorted().toList()
        }
    }

    private fun isDomainFile(name: String) = ENDINGS.any { name.endsWith(it) }

    private fun tell(line: String) = session.terminal.err.println("bench: $line")

    private companion object {
        const val MOST = 1e8
        val ENDINGS = listOf(".geojson", ".wkt", ".poly", ".trigrid.json")
    }
}
