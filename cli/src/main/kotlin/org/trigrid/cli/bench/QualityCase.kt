package org.trigrid.cli.bench

import org.trigrid.domain.Domain
import org.trigrid.mesh.TriMesh
import org.trigrid.quality.QualityReport
import org.trigrid.spacing.SizeDeviation

/** The figures of one mesh of one domain, in the order of [QualityMeasure]. */
internal class QualityCase(val domain: String, mesh: TriMesh, of: Domain) {
    private val figures: DoubleArray

    init {
        val report = QualityReport.of(mesh, 0)
        figures = doubleArrayOf(
            report.elementCount.toDouble(), report.minQuality, report.quality05, report.meanQuality, report.minAngle,
            report.meanMinAngle, report.maxAngle, report.degree6, SizeDeviation.of(mesh, of),
        )
    }

    operator fun get(measure: QualityMeasure): Double = figures[measure.ordinal]
}

/** Columns of the table of quality. */
internal enum class QualityMeasure(val title: String, val decimals: Int) {
    ELEMENTS("elements", 0),
    MIN_Q("min q", 3),
    Q05("5 % q", 3),
    MEAN_Q("mean q", 4),
    MIN_ANGLE("min angle", 1),
    MEAN_MIN_ANGLE("mean of min angles", 1),
    MAX_ANGLE("max angle", 1),
    DEGREE_6("degree 6", 3),
    SIZE_DEVIATION("size deviation", 3),
}
