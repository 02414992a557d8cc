package org.trigrid.cli.bench

import org.trigrid.cli.bench.MarkdownTable.Companion.number
import org.trigrid.cli.bench.MarkdownTable.Companion.rounded
import org.trigrid.diagnostics.Stage

/** Puts measurements of speed into tables. */
internal class SpeedTables(private val cases: List<SpeedCase>, private val peers: Map<Peer, String>) {
    fun text(): String = listOf(times(), stages()).joinToString("\n") + if (peers.isEmpty()) "" else "\n" + comparison()

    private fun times(): String {
        val table = MarkdownTable(
            "domain", "boundary nodes", "elements", "least s", "median s", "process s", "elements/s", "growth",
        )
        for (case in cases) {
            table.add(
                listOf(
                    case.name, number(case.boundaryNodes.toDouble(), 0), number(case.elements.toDouble(), 0),
                    rounded(case.least), rounded(case.median), rounded(case.processMedian), rate(case.rate), growth(case),
                ),
            )
        }
        return "$TIMES_HEADING\n$table"
    }

    private fun stages(): String {
        val table = MarkdownTable("domain", *Stage.entries.map { it.name.lowercase() }.toTypedArray(), "whole")
        for (case in cases) {
            val stages = Stage.entries.map { case.secondsOf(it) * 1e9 / case.elements }
            table.add(listOf(case.name) + (stages + case.median * 1e9 / case.elements).map { number(it, 0) })
        }
        return "$STAGES_HEADING\n$table"
    }

    private fun comparison(): String {
        val table = MarkdownTable(
            "domain", "TriGrid elements/s",
            *peers.keys.flatMap { listOf("${it.title} elements", "CPU s", "elements/s", "TriGrid is faster by") }.toTypedArray(),
        )
        for (case in cases) {
            table.add(listOf(case.name, rate(case.rate)) + peers.keys.flatMap { ofPeer(case, it) })
        }
        return "$COMPARISON_HEADING " + peers.entries.joinToString(", ") { "${it.key.title} ${it.value}" } + ".\n\n$table"
    }

    private fun ofPeer(case: SpeedCase, peer: Peer): List<String> {
        val run = case.peers[peer] ?: return List(4) { "–" }
        val mark = if (run.keepsBoundary) "" else " (boundary changed)"
        return listOf(
            number(run.elements.toDouble(), 0) + mark, rounded(run.seconds.min()), rate(case.rateOf(peer)),
            rounded(case.rate / case.rateOf(peer)),
        )
    }

    /** Seconds over those of the case of a tenth of the size, both per element made, times ten. */
    private fun growth(case: SpeedCase): String {
        val smaller = cases.firstOrNull { it.family == case.family && Math.abs(it.size * 10 / case.size - 1) < 0.01 }
            ?: return "–"
        return rounded(10 * (case.least / case.elements) / (smaller.least / smaller.elements))
    }

    private fun rate(value: Double) = if (!value.isFinite()) "–" else number(value / 1000, 0) + " k"

    private companion object {
        val TIMES_HEADING = """
            CPU seconds of the meshing thread, validation to renumbering: the least and the median of the runs. *process*: those of
            the whole process, with collector and compiler, in steps of 10 ms. *growth*: seconds for ten times as many elements over seconds.
            """.trimIndent() + "\n"
        const val STAGES_HEADING = "Nanoseconds of CPU an element by stage (medians):\n"
        const val COMPARISON_HEADING =
            "The peers, in the same run on the same boundary nodes; CPU seconds of the meshing call alone, best run of each:"
    }
}
