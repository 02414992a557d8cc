package org.trigrid.cli

import org.trigrid.domain.DomainCheck
import org.trigrid.project.DomainInputs
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Mixin
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Tells all that keeps a domain from being meshed. */
@Command(
    name = "check",
    description = ["List everything that keeps a domain from being meshed, one line a fault, and mesh nothing."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = ["", "Example:", "  trigrid check coast.geojson", "", "Exit code 0 without faults, 3 with."],
)
internal class CheckCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(
        paramLabel = "IN",
        description = ["A file with domains: a project, GeoJSON, WKT, SVG, DXF, Gmsh .geo, Triangle .poly or a table of points."],
    )
    lateinit var input: Path

    @Mixin
    lateinit var arguments: ExplodingArguments

    @Mixin
    lateinit var inner: InnerArguments

    override fun call(): Int {
        val options = inner.over(arguments.toOptions(spec.commandLine()), spec.commandLine())
        if (MeshInput.isMesh(input)) throw ParameterException(spec.commandLine(), "$input is a mesh; 'trigrid info' checks meshes")
        val lines = FaultLines(session.terminal.err, input.toString())
        var isFaulty = false
        for (given in InputFailure.naming(input) { DomainInputs.read(input, options) }) {
            val domain = given.domain
            val faults = DomainCheck.check(domain)
            lines.print(faults)
            if (faults.isEmpty()) {
                lines.printWarnings(DomainCheck.warnings(domain))
                val regions = if (domain.regions.size > 1) "${domain.regions.size} regions, " else ""
                val counts = "${domain.nodeCount} nodes, ${domain.loopCount} loops, ${regions}no faults"
                session.terminal.out.println(OneLine.of("$input: ${given.name}: $counts"))
            }
            isFaulty = isFaulty || faults.isNotEmpty()
        }
        return if (isFaulty) ExitCodes.INVALID_DOMAIN else ExitCodes.DONE
    }
}
