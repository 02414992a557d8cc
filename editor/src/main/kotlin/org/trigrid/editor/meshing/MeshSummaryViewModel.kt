package org.trigrid.editor.meshing

import org.trigrid.editor.tool.Figures
import org.trigrid.quality.QualityReport
import org.trigrid.quality.WorstElement

/** The figures of a mesh in words. No controls. */
internal class MeshSummaryViewModel private constructor(view: MeshView) {
    private val quality: QualityReport = view.report?.quality ?: QualityReport.of(view.mesh)

    val counts: String = "${Figures.count(view.mesh.nodeCount)} nodes, ${Figures.count(view.mesh.elementCount)} elements"

    val worstAngle: String = "min angle " + Figures.angle(quality.minAngle)

    val worst: List<WorstElement> = quality.worstElements

    /** Name and value of each figure, in the order in which they are shown. */
    val rows: List<Pair<String, String>> = buildList {
        add("Nodes" to Figures.count(view.mesh.nodeCount))
        add("on the boundary" to Figures.count(view.mesh.boundaryNodeCount))
        add("Elements" to Figures.count(view.mesh.elementCount))
        add("Edges" to Figures.count(view.mesh.edgeCount))
        add("Quality, mean" to Figures.plain(quality.meanQuality, 3))
        add("Quality, worst" to Figures.plain(quality.minQuality, 3))
        add("Smallest angle" to Figures.angle(quality.minAngle))
        add("Largest angle" to Figures.angle(quality.maxAngle))
        add("Nodes of degree 6" to percent(quality.degree6))
        view.report?.let { report ->
            add("Bandwidth" to "${Figures.count(report.numberingBefore.bandwidth)} → ${Figures.count(report.numberingAfter.bandwidth)}")
            add("Profile" to "${report.numberingBefore.profile} → ${report.numberingAfter.profile}")
            add("Time" to seconds(report.totalSeconds))
        }
    }

    /** Elements by quality, ten classes from 0 to 1. */
    val histogram: IntArray = quality.qualityHistogram()

    private fun percent(share: Double): String = if (share.isNaN()) "–" else Figures.plain(100 * share, 3) + " %"

    private fun seconds(value: Double): String =
        if (value < 1) Figures.plain(1000 * value, 3) + " ms" else Figures.plain(value, 3) + " s"

    companion object {
        private var last: Pair<MeshView, MeshSummaryViewModel>? = null

        /** The summary of [view]; asked again for the same one it is the same. */
        fun of(view: MeshView): MeshSummaryViewModel {
            last?.let { if (it.first === view) return it.second }
            return MeshSummaryViewModel(view).also { last = view to it }
        }
    }
}
