package org.trigrid.cli

import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.numbering.NumberingMetrics
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Renumbers the nodes of a mesh that is there. */
@Command(
    name = "renumber",
    description = ["Renumber the nodes of a mesh file for a small bandwidth and profile."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = ["", "Example:", "  trigrid renumber made-elsewhere.msh -o renumbered.msh"],
)
internal class RenumberCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A mesh file: .msh, .vtu, .mesh, .ele."])
    lateinit var input: Path

    @Mixin
    lateinit var target: MeshOutputArguments

    @Option(names = ["--numbering"], paramLabel = "METHOD", description = ["best, or cuthill-mckee for the paper's. Default: best."])
    var numbering: String = "best"

    override fun call(): Int {
        val method = METHODS[numbering]
            ?: throw ParameterException(spec.commandLine(), "--numbering must be best or cuthill-mckee, not $numbering")
        target.check(spec.commandLine())
        val quadratic = MeshInput.readEither(input).quadratic ?: return renumber(method)
        if (target.check(spec.commandLine()).highestOrder < 2) {
            throw ParameterException(spec.commandLine(), "the elements of $input have six nodes; choose a format that has them with --format")
        }
        val renumbered = Numbering.renumber(quadratic, method)
        target.write(renumbered, spec.commandLine())
        tell(quadratic.nodeCount, Numbering.metrics(quadratic), Numbering.metrics(renumbered))
        return ExitCodes.DONE
    }

    private fun renumber(method: NumberingMethod): Int {
        val mesh = ValidMesh(session).read(input) ?: return ExitCodes.INVALID_DOMAIN
        val renumbered = Numbering.renumber(mesh, method)
        target.write(renumbered, spec.commandLine())
        tell(mesh.nodeCount, Numbering.metrics(mesh), Numbering.metrics(renumbered))
        return ExitCodes.DONE
    }

    private fun tell(nodes: Int, before: NumberingMetrics, after: NumberingMetrics) = session.terminal.out.println(
        "${target.output}: $nodes nodes, bandwidth ${before.bandwidth} -> ${after.bandwidth}, profile ${before.profile} -> ${after.profile}",
    )

    private companion object {
        val METHODS = mapOf("best" to NumberingMethod.BEST, "cuthill-mckee" to NumberingMethod.CUTHILL_MCKEE)
    }
}
