package org.trigrid.cli

import org.trigrid.MeshRework
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.quality.QualityReport
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Improves the elements of a mesh that is there. */
@Command(
    name = "improve",
    description = [
        "Make the elements of a mesh file better: nodes inside move, come and go; boundaries and lines stay exactly as they are.",
    ],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = ["", "Example:", "  trigrid improve made-elsewhere.msh -o better.msh"],
)
internal class ImproveCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A mesh file: .msh, .vtu, .mesh, .ele."])
    lateinit var input: Path

    @Mixin
    lateinit var target: MeshOutputArguments

    @Option(names = ["--no-renumber"], description = ["Leave the nodes as they come."])
    var noRenumber: Boolean = false

    override fun call(): Int {
        target.check(spec.commandLine())
        val mesh = ValidMesh(session).read(input) ?: return ExitCodes.INVALID_DOMAIN
        val improved = ProgressBar(session.terminal, session.cancellation).use { MeshRework.improve(mesh, it) }
        target.write(Numbering.renumber(improved, if (noRenumber) NumberingMethod.NONE else NumberingMethod.BEST), spec.commandLine())
        val before = QualityReport.of(mesh)
        val after = QualityReport.of(improved)
        session.terminal.out.println(
            "${target.output}: ${mesh.elementCount} -> ${improved.elementCount} elements, " +
                "smallest angle ${Figures.of(before.minAngle)}° -> ${Figures.of(after.minAngle)}°, " +
                "mean quality ${Figures.of(before.meanQuality)} -> ${Figures.of(after.meanQuality)}",
        )
        return ExitCodes.DONE
    }
}
