package org.trigrid.project

import org.trigrid.MeshReport
import org.trigrid.front.Strategy
import org.trigrid.spacing.Sizes

/** The figures of one mesh of a paper case; a line of `src-test-data/expected/paper.csv`. */
internal class PaperFigures(
    val case: String,
    val strategy: Strategy,
    val sizes: Sizes,
    val nodes: Int,
    val elements: Int,
    val fallbacks: Int,
    val minQuality: Double,
    val quality05: Double,
    val meanQuality: Double,
    val minAngle: Double,
    val degree6: Double,
    val bandwidthBefore: Int,
    val bandwidthAfter: Int,
    val profileAfter: Long,
) {
    val key: String get() = "$case ${strategy.word} ${sizes.word}"

    /** Rounded to what a reader of a difference can judge. */
    fun toLine(): String = listOf(
        case, strategy.word, sizes.word, nodes, elements, fallbacks, minQuality.short(3), quality05.short(3), meanQuality.short(4),
        minAngle.short(1), degree6.short(3), bandwidthBefore, bandwidthAfter, profileAfter,
    ).joinToString(",")

    /** What is worse than [expected] by more than the tolerances of `src-test-data/expected/README.md`. */
    fun faults(expected: PaperFigures): List<String> {
        val faults = ArrayList<String>()
        fun need(holds: Boolean, what: String, was: Any, now: Any) {
            if (!holds) faults.add("$key: $what was $was, is $now")
        }
        need(Math.abs(nodes - expected.nodes) <= 0.05 * expected.nodes, "nodes", expected.nodes, nodes)
        need(Math.abs(elements - expected.elements) <= 0.05 * expected.elements, "elements", expected.elements, elements)
        need(fallbacks <= 1.25 * expected.fallbacks + 3, "fallbacks", expected.fallbacks, fallbacks)
        need(minQuality >= expected.minQuality - 0.1, "smallest quality", expected.minQuality, minQuality)
        need(quality05 >= expected.quality05 - 0.02, "5 % quality", expected.quality05, quality05)
        need(meanQuality >= expected.meanQuality - 0.005, "mean quality", expected.meanQuality, meanQuality)
        need(minAngle >= expected.minAngle - 4, "smallest angle", expected.minAngle, minAngle)
        need(degree6 >= expected.degree6 - 0.05, "degree 6", expected.degree6, degree6)
        need(bandwidthAfter <= 1.15 * expected.bandwidthAfter, "bandwidth", expected.bandwidthAfter, bandwidthAfter)
        need(profileAfter <= 1.15 * expected.profileAfter, "profile", expected.profileAfter, profileAfter)
        return faults
    }

    companion object {
        const val HEADER = "case,strategy,sizes,nodes,elements,fallbacks,min_q,p05_q,mean_q,min_angle,degree6," +
            "bandwidth_before,bandwidth_after,profile_after"

        private val Enum<*>.word get() = name.lowercase()

        private fun Double.short(digits: Int) = "%.${digits}f".format(java.util.Locale.ROOT, this)

        fun of(case: String, strategy: Strategy, sizes: Sizes, report: MeshReport) = PaperFigures(
            case, strategy, sizes, report.nodeCount, report.elementCount, report.fallbacks, report.quality.minQuality,
            report.quality.quality05, report.quality.meanQuality, report.quality.minAngle, report.quality.degree6,
            report.numberingBefore.bandwidth, report.numberingAfter.bandwidth, report.numberingAfter.profile,
        )

        fun parse(line: String): PaperFigures {
            val f = line.split(',')
            return PaperFigures(
                f[0], Strategy.valueOf(f[1].uppercase()), Sizes.valueOf(f[2].uppercase()), f[3].toInt(), f[4].toInt(),
                f[5].toInt(), f[6].toDouble(), f[7].toDouble(), f[8].toDouble(), f[9].toDouble(), f[10].toDouble(),
                f[11].toInt(), f[12].toInt(), f[13].toLong(),
            )
        }
    }
}
