package org.trigrid

import org.trigrid.diagnostics.Stage
import org.trigrid.numbering.NumberingMetrics
import org.trigrid.quality.QualityReport

/** The figures of one run of [MeshGenerator]. */
public class MeshReport internal constructor(
    @get:JvmName("nodeCount") public val nodeCount: Int,
    @get:JvmName("elementCount") public val elementCount: Int,
    @get:JvmName("boundaryNodeCount") public val boundaryNodeCount: Int,
    /** Boundary loops, outer and holes. */
    @get:JvmName("loopCount") public val loopCount: Int,
    /** Elements expected from the sizes before meshing. */
    @get:JvmName("expectedElements") public val expectedElements: Double,
    /** Elements that the front could make only by the constrained-Delaunay way out. */
    @get:JvmName("fallbacks") public val fallbacks: Int,
    @get:JvmName("quality") public val quality: QualityReport,
    /** Bandwidth and profile in the order in which the nodes were made, the given ones first. */
    @get:JvmName("numberingBefore") public val numberingBefore: NumberingMetrics,
    @get:JvmName("numberingAfter") public val numberingAfter: NumberingMetrics,
    private val stageSeconds: DoubleArray,
) {
    /** Wall time of [stage], in seconds. */
    public fun seconds(stage: Stage): Double = stageSeconds[stage.ordinal]

    /** Wall time of all stages together, in seconds. */
    @get:JvmName("totalSeconds")
    public val totalSeconds: Double get() = stageSeconds.sum()
}
