package org.trigrid.cli

import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MeshViolation
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NumberingMetrics
import org.trigrid.quality.QualityReport
import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Path
import java.util.concurrent.Callable

/** Tells what is in a mesh file. */
@Command(
    name = "info",
    description = ["Tell what is in a mesh file, how good its elements are and whether it is valid."],
    mixinStandardHelpOptions = true,
    footer = ["", "Example:", "  trigrid info plate.msh"],
)
internal class InfoCommand(private val session: Session) : Callable<Int> {
    @Parameters(paramLabel = "FILE", description = ["A mesh file: .msh, .vtu, .mesh, .ele."])
    lateinit var file: Path

    override fun call(): Int {
        val mesh = MeshInput.read(file)
        session.terminal.out.print(describe(mesh))
        val violations = MeshCheck.check(mesh)
        for (violation in violations) session.terminal.err.println(line(violation))
        return if (violations.isEmpty()) ExitCodes.DONE else ExitCodes.INVALID_DOMAIN
    }

    private fun describe(mesh: TriMesh): String = buildString {
        val quality = QualityReport.of(mesh)
        val numbering = NumberingMetrics.of(mesh)
        line("nodes", mesh.nodeCount)
        line("elements", mesh.elementCount)
        line("boundary edges", mesh.boundaryEdgeCount)
        for (region in mesh.regions) {
            val count = if (mesh.regions.size == 1) "" else ", ${mesh.elementsIn(region.name).size} elements"
            line("region", region.name + (if (region.material > 0) " (material ${region.material})" else "") + count)
        }
        if (mesh.pointCount > 0) line("points", mesh.pointCount)
        line("tags", mesh.tags.joinToString { it.ifEmpty { "(unnamed)" } })
        line("quality", "min ${Figures.of(quality.minQuality)}, 5 % ${Figures.of(quality.quality05)}, mean ${Figures.of(quality.meanQuality)}")
        line(
            "angles",
            "min ${Figures.of(quality.minAngle)}, mean of the smallest ${Figures.of(quality.meanMinAngle)}, " +
                "max ${Figures.of(quality.maxAngle)} degrees",
        )
        line("six neighbours", Figures.percent(quality.degree6) + " of the interior nodes")
        line("bandwidth", numbering.bandwidth)
        line("profile", numbering.profile)
    }

    private fun StringBuilder.line(name: String, value: Any) {
        append((name + ":").padEnd(NAME_WIDTH)).append(value).append('\n')
    }

    private fun line(violation: MeshViolation): String =
        "$file: ${violation.kind} at (${violation.x}, ${violation.y}): ${violation.message}"

    private companion object {
        const val NAME_WIDTH = 16
    }
}
