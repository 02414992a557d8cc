package org.trigrid.cli

import org.trigrid.domain.Region
import org.trigrid.mesh.MeshCheck
import org.trigrid.mesh.MeshViolation
import org.trigrid.mesh.QuadraticMesh
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

    override fun call(): Int = MeshInput.readEither(file, ::tell) {
        session.terminal.out.print(describe(it))
        ExitCodes.DONE
    }

    private fun tell(mesh: TriMesh): Int {
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
        for (region in mesh.regions) region(region, mesh.elementsIn(region.name).size, mesh.regions.size > 1)
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

    private fun describe(mesh: QuadraticMesh): String = buildString {
        val numbering = NumberingMetrics.of(mesh)
        line("nodes", mesh.nodeCount)
        line("elements", "${mesh.elementCount} of six nodes")
        line("boundary edges", mesh.boundaryEdgeCount)
        for ((r, region) in mesh.regions.withIndex()) {
            region(region, (0 until mesh.elementCount).count { mesh.regionOf(it) == r }, mesh.regions.size > 1)
        }
        if (mesh.pointCount > 0) line("points", mesh.pointCount)
        line("tags", mesh.tags.joinToString { it.ifEmpty { "(unnamed)" } })
        val jacobian = (0 until mesh.elementCount).minOf { mesh.leastJacobian(it) / (2 * mesh.area(it)) }
        line("least Jacobian", Figures.of(jacobian) + " of the element's mean")
        line("bandwidth", numbering.bandwidth)
        line("profile", numbering.profile)
    }

    private fun StringBuilder.region(region: Region, elements: Int, isOneOfSeveral: Boolean) {
        val material = if (region.material > 0) " (material ${region.material})" else ""
        line("region", region.name + material + if (isOneOfSeveral) ", $elements elements" else "")
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
