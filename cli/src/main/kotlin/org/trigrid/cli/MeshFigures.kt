package org.trigrid.cli

import org.trigrid.MeshReport
import org.trigrid.mesh.QuadraticMesh

/** The figures of one mesh, for the report and the line on the terminal. */
internal class MeshFigures(
    val name: String,
    val report: MeshReport,
    val clock: RunClock,
    /** The mesh of six-node elements that was written, or null. */
    val quadratic: QuadraticMesh? = null,
) {
    fun summary(): String =
        "${report.nodeCount} nodes, ${report.elementCount} elements, smallest angle ${Figures.of(report.quality.minAngle)}°, " +
            "mean quality ${Figures.of(report.quality.meanQuality)}, bandwidth ${report.numberingAfter.bandwidth}, " +
            secondOrder() + Figures.seconds(clock.totalSeconds)

    private fun secondOrder() = quadratic?.let { secondOrder(it) + ", " }.orEmpty()

    companion object {
        /** Figures of six-node elements for a line. */
        fun secondOrder(mesh: QuadraticMesh): String {
            val straightened = mesh.straightenedEdgeCount
            val moved = if (straightened > 0) ", $straightened edges less curved than their shapes" else ""
            return "second order ${mesh.nodeCount} nodes, bandwidth ${mesh.bandwidth}$moved"
        }
    }
}
