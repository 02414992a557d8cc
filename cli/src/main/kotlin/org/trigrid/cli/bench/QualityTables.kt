package org.trigrid.cli.bench

import org.trigrid.cli.bench.MarkdownTable.Companion.number
import java.util.Locale

/** Puts the figures of quality into tables: the medians over the domains first, then each way domain by domain. */
internal class QualityTables(private val cases: Map<String, List<QualityCase>>) {
    fun text(): String = "Medians over the domains:\n\n${medians()}\n" + comparisons() +
        cases.entries.joinToString("") { (title, of) -> "\n### $title\n\n${domains(of)}" }

    private fun medians(): String {
        val table = MarkdownTable("", "domains", *QualityMeasure.entries.map { it.title }.toTypedArray())
        for ((title, of) in cases) {
            table.add(listOf(title, of.size.toString()) + QualityMeasure.entries.map { number(median(of, it), it.decimals) })
        }
        table.add(listOf("goal of *smooth*") + GOALS)
        return table.toString()
    }

    private fun domains(of: List<QualityCase>): String {
        val table = MarkdownTable("domain", *QualityMeasure.entries.map { it.title }.toTypedArray())
        for (case in of) table.add(listOf(case.domain) + QualityMeasure.entries.map { number(case[it], it.decimals) })
        return table.toString()
    }

    /** Domains on which ours is behind its peer by more than is worth a word. */
    private fun comparisons(): String = PAIRS.mapNotNull { (ours, theirs) ->
        val theirCases = cases[theirs.title]?.associateBy { it.domain } ?: return@mapNotNull null
        val pairs = cases.getValue(ours).mapNotNull { our -> theirCases[our.domain]?.let { our to it } }
        val ratio = SpeedCase.median(pairs.map { (our, their) -> our[ELEMENTS] / their[ELEMENTS] })
        val behind = pairs.filter { (our, their) -> isBehind(our, their) }.joinToString { (our, their) ->
            "${our.domain} (min angle ${difference(our, their, QualityMeasure.MIN_ANGLE, 1)}, " +
                "mean q ${difference(our, their, QualityMeasure.MEAN_Q, 4)})"
        }
        "$ours against ${theirs.title}: ${number(ratio, 2)} times as many elements (median); min angle lower by more " +
            "than 1 degree or mean q by more than 0.005 on: ${behind.ifEmpty { "none" }}.\n"
    }.joinToString("\n")

    private fun isBehind(our: QualityCase, their: QualityCase) =
        our[QualityMeasure.MIN_ANGLE] < their[QualityMeasure.MIN_ANGLE] - 1 ||
            our[QualityMeasure.MEAN_Q] < their[QualityMeasure.MEAN_Q] - 0.005

    private fun difference(our: QualityCase, their: QualityCase, measure: QualityMeasure, decimals: Int) =
        "%+.${decimals}f".format(Locale.ROOT, our[measure] - their[measure])

    private fun median(of: List<QualityCase>, measure: QualityMeasure): Double =
        if (of.isEmpty()) Double.NaN else SpeedCase.median(of.map { it[measure] })

    private companion object {
        val ELEMENTS = QualityMeasure.ELEMENTS

        /** One per column after the title; the floor is what Gmsh has. */
        val GOALS = listOf("", "within 15 % of Gmsh", "", "≥ 0.92", "≥ 0.980", "≥ 32", "≥ 54.5", "≤ 100", "≥ 0.85", "≤ 0.2")
        val PAIRS = listOf("TriGrid smooth" to Peer.GMSH, "TriGrid grade" to Peer.NETGEN)
    }
}
