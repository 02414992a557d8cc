package org.trigrid.cli

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

    override fun call(): Int {
        val read = MeshInput.readEither(file)
        session.terminal.out.print(describe(read.corners, read.quadratic))
        val faults = MeshCheck.check(read.corners).map { line(it) } + read.quadratic?.let { folded(it) }.orEmpty()
        for (fault in faults) session.terminal.err.println(fault)
        return if (faults.isEmpty()) ExitCodes.DONE else ExitCodes.INVALID_DOMAIN
    }

    /** Elements of six nodes that are not the image of a triangle. */
    private fun folded(mesh: QuadraticMesh): List<String> = (0 until mesh.elementCount).filter { !(mesh.leastJacobian(it) > 0) }.map {
        val corner = mesh.nodeOf(it, 0)
        "$file: FOLDED at (${mesh.x(corner)}, ${mesh.y(corner)}): the Jacobian of element $it falls to ${mesh.leastJacobian(it)}"
    }

    private fun describe(mesh: TriMesh, quadratic: QuadraticMesh?): String = buildString {
        val quality = QualityReport.of(mesh)
        val numbering = if (quadratic == null) NumberingMetrics.of(mesh) else NumberingMetrics.of(quadratic)
        if (quadratic == null) line("nodes", mesh.nodeCount)
        else line("nodes", "${quadratic.nodeCount}, six an element, ${mesh.nodeCount} of them corners")
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
