package org.trigrid.cli

import org.trigrid.MeshRework
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
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

/** Divides the elements of a mesh that is there. */
@Command(
    name = "refine",
    description = ["Divide each element of a mesh file into four by the middles of its edges."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  trigrid refine plate.msh -o fine.msh --times 2",
        "  trigrid refine part.msh -o fine.msh --project part.trigrid.json",
        "",
        "Boundaries stay straight between their nodes, unless a project tells their curves.",
    ],
)
internal class RefineCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A mesh file: .msh, .vtu, .mesh, .ele."])
    lateinit var input: Path

    @Mixin
    lateinit var target: MeshOutputArguments

    @Option(names = ["--times"], paramLabel = "N", description = ["How often, 1 to 10. Default: 1."])
    var times: Int = 1

    @Option(
        names = ["--project"], paramLabel = "FILE",
        description = ["The project that the mesh was made of: new nodes of its boundary lie on the project's curves."],
    )
    var project: Path? = null

    @Option(names = ["--no-renumber"], description = ["Leave the nodes as they come: the old ones first, with their numbers."])
    var noRenumber: Boolean = false

    override fun call(): Int {
        if (times !in 1..MOST) throw ParameterException(spec.commandLine(), "--times must be from 1 to $MOST, not $times")
        target.check(spec.commandLine())
        var mesh = ValidMesh(session).read(input) ?: return ExitCodes.INVALID_DOMAIN
        val before = mesh.elementCount
        if (before * Math.pow(4.0, times.toDouble()) > Int.MAX_VALUE / 3) {
            throw ParameterException(spec.commandLine(), "$before elements divided $times times are too many")
        }
        val curves = project?.let { file -> InputFailure.naming(file) { ProjectFile.read(file) } }
        val middles = if (curves == null) EdgeMiddles.STRAIGHT else ShapeMiddles(curves.path)
        repeat(times) { mesh = MeshRework.refine(mesh, middles) }
        target.write(Numbering.renumber(mesh, if (noRenumber) NumberingMethod.NONE else NumberingMethod.BEST), spec.commandLine())
        session.terminal.out.println("${target.output}: ${mesh.nodeCount} nodes, $before -> ${mesh.elementCount} elements")
        return ExitCodes.DONE
    }

    private companion object {
        const val MOST = 10
    }
}
