package org.trigrid.cli

import org.trigrid.MeshReport

/** The figures of one mesh, for the report and the line on the terminal. */
internal class MeshFigures(val name: String, val report: MeshReport, val clock: RunClock) {
    fun summary(): String =
        "${report.nodeCount} nodes, ${report.elementCount} elements, smallest angle ${Figures.of(report.quality.minAngle)}°, " +
            "mean quality ${Figures.of(report.quality.meanQuality)}, bandwidth ${report.numberingAfter.bandwidth}, " +
            Figures.seconds(clock.totalSeconds)
}
