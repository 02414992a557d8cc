package org.trigrid.cli

import org.trigrid.MeshRework
import org.trigrid.domain.Domain
import org.trigrid.domain.InnerParts
import org.trigrid.io.DomainFormat
import org.trigrid.io.DomainFormats
import org.trigrid.io.FileFormat
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.io.NamedDomain
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.project.DomainInputs
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project
import org.trigrid.project.ProjectFile
import org.trigrid.project.ShapeMiddles
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Writes a mesh or a domain in another format. */
@Command(
    name = "convert",
    description = ["Write a mesh in another format, or a domain in another; or the outline of a mesh as a domain."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  trigrid convert plate.msh plate.vtu",
        "  trigrid convert plate.msh plate.msh --format msh41-binary",
        "  trigrid convert plate.msh plate.inp --order 2 --project plate.trigrid.json",
        "  trigrid convert part.dxf part.trigrid.json --spacing 2",
        "  trigrid convert plate.msh outline.geojson",
        "  trigrid convert --list",
    ],
)
internal class ConvertCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(index = "0", arity = "0..1", paramLabel = "IN", description = ["A mesh or a domain; the ending tells which."])
    var input: Path? = null

    @Parameters(index = "1", arity = "0..1", paramLabel = "OUT", description = ["The file to write; its ending tells the format."])
    var output: Path? = null

    @Option(names = ["--format"], paramLabel = "NAME", description = ["Another format than the ending of OUT tells."])
    var format: String? = null

    @Option(names = ["--list"], description = ["List the formats and what can be done with them."])
    var list: Boolean = false

    @Mixin
    lateinit var ordering: OrderArguments

    @Option(
        names = ["--project"], paramLabel = "FILE",
        description = ["With --order 2: the project that the mesh was made of; new nodes of its boundary lie on the project's curves."],
    )
    var project: Path? = null

    @Mixin
    lateinit var exploding: ExplodingArguments

    @Mixin
    lateinit var inner: InnerArguments

    override fun call(): Int {
        if (list) {
            for (line in FormatList.lines()) session.terminal.out.println(line)
            return ExitCodes.DONE
        }
        val from = input ?: throw ParameterException(spec.commandLine(), "say what to convert: IN and OUT")
        val to = output ?: throw ParameterException(spec.commandLine(), "say what to write: OUT")
        val options = inner.over(exploding.toOptions(spec.commandLine()), spec.commandLine())
        if (project != null && ordering.order == 1) throw ParameterException(spec.commandLine(), "--project is for --order 2")
        if (MeshInput.isMesh(from)) return convertMesh(from, to)
        ordering.check(null, spec.commandLine())
        val target = domainFormat(to)
        if (target == null && !DomainInputs.isProject(to)) {
            val message = "a domain can be written as ${writable()}; meshes of it are made by 'trigrid mesh'"
            throw ParameterException(spec.commandLine(), message)
        }
        OutputPlace.check(to)
        val domains = InputFailure.naming(from) { DomainInputs.read(from, options) }.map { NamedDomain(it.name, it.domain) }
        if (target == null) writeProject(domains, to) else writeDomains(domains, to, target)
        session.terminal.out.println("$to: ${domains.size} domains, ${domains.sumOf { it.domain.nodeCount }} nodes")
        return ExitCodes.DONE
    }

    private fun convertMesh(from: Path, to: Path): Int {
        val wanted = format
        val isMesh = if (wanted == null) MeshFormats.forWriting(to) != null else MeshFormats.named(wanted) != null
        val asDomain = if (isMesh) null else domainFormat(to)
        val meshFormat = if (asDomain == null) MeshOutput.format(format, to, spec.commandLine()) else null
        ordering.check(meshFormat, spec.commandLine())
        OutputPlace.check(to)
        val read = MeshInput.readEither(from)
        val quadratic = read.quadratic
        if (ordering.order == 2 && quadratic == null) return raise(from, to, meshFormat!!)
        if (quadratic != null && meshFormat != null && ordering.given != 1) return copy(quadratic, from, to, meshFormat)
        val mesh = read.corners
        if (meshFormat != null) MeshFormats.write(mesh, to, meshFormat)
        else writeDomains(listOf(NamedDomain(mesh.regionName, mesh.outline())), to, asDomain!!)
        session.terminal.out.println("$to: ${mesh.nodeCount} nodes, ${mesh.elementCount} elements")
        return ExitCodes.DONE
    }

    private fun copy(mesh: QuadraticMesh, from: Path, to: Path, meshFormat: MeshFormat): Int {
        if (project != null) throw ParameterException(spec.commandLine(), "--project is for elements of three nodes; those of $from have six")
        if (meshFormat.highestOrder < 2) {
            throw ParameterException(spec.commandLine(), "the elements of $from have six nodes, which ${meshFormat.name} has not; --order 1 leaves their corners")
        }
        MeshFormats.write(mesh, to, meshFormat)
        session.terminal.out.println("$to: ${mesh.elementCount} elements, ${MeshFigures.secondOrder(mesh)}")
        return ExitCodes.DONE
    }

    /** Writes a mesh with elements of six nodes. */
    private fun raise(from: Path, to: Path, meshFormat: MeshFormat): Int {
        val curves = project?.let { file -> InputFailure.naming(file) { ProjectFile.read(file) } }
        val mesh = ValidMesh(session).read(from) ?: return ExitCodes.INVALID_DOMAIN
        val quadratic = MeshRework.secondOrder(mesh, if (curves == null) EdgeMiddles.STRAIGHT else ShapeMiddles(curves.path))
        MeshFormats.write(quadratic, to, meshFormat)
        session.terminal.out.println("$to: ${quadratic.elementCount} elements, ${MeshFigures.secondOrder(quadratic)}")
        return ExitCodes.DONE
    }

    private fun domainFormat(file: Path): DomainFormat? {
        if (DomainInputs.isProject(file)) return null
        val found = format?.let { DomainFormats.named(it) } ?: if (format == null) DomainFormats.forFile(file) else null
        return found?.takeIf { it.canWrite }
    }

    private fun writeDomains(domains: List<NamedDomain>, to: Path, target: DomainFormat) = try {
        DomainFormats.write(domains, to, target)
    } catch (error: IllegalArgumentException) {
        throw java.io.IOException("cannot be written to $to: ${error.message}", error)
    }

    /** Loops of nodes, and what the domains have inside. */
    private fun writeProject(domains: List<NamedDomain>, to: Path) {
        val loops = domains.flatMap { named -> (0 until named.domain.loopCount).map { loop(named.domain, it) } }
        val inner = domains.fold(InnerParts.NONE) { all, named -> all.with(InnerParts.of(named.domain)) }
        val own = domains.first().domain.regions[0]
        val region = if (inner.markerCount == 0) own.withName(domains.first().name) else own
        val project = Project.builder().loops(loops).inner(inner).region(region).build()
        ProjectFile.write(to, project)
    }

    private fun loop(domain: Domain, loop: Int): NodeLoop {
        val nodes = domain.loopNodes(loop)
        val tags = nodes.indices.map { domain.tags[domain.segmentTag(domain.loopStart(loop) + it)] }
        return NodeLoop(DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) }, tags)
    }

    private fun writable() = (listOf(".trigrid.json") + DomainFormats.all().filter { it.canWrite }.map { it.endings[0] }).joinToString()
}

/** All formats in lines for people. */
internal object FormatList {
    fun lines(): List<String> = listOf("meshes:") + MeshFormats.all().map(::line) + "domains:" +
        "  project       read, write  .trigrid.json  TriGrid's project file" + DomainFormats.all().map(::line)

    private fun line(format: FileFormat): String {
        val can = listOfNotNull("read".takeIf { format.canRead }, "write".takeIf { format.canWrite }).joinToString(", ")
        val endings = format.endings.take(2).joinToString(" ")
        return "  %-13s %-12s %-14s %s".format(java.util.Locale.ROOT, format.name, can, endings, format.title)
    }
}
