package org.trigrid.cli

import org.trigrid.diagnostics.Fault
import org.trigrid.domain.DomainWarning
import java.io.PrintStream

/** Prints what is wrong with the domain of a [file], one line a fault: file, kind, place, nodes, words. */
internal class FaultLines(private val err: PrintStream, private val file: String) {
    fun print(faults: List<Fault>) {
        for (it in faults) err.println(OneLine.of("$file: ${it.kind}" + place(it.x, it.y, it.nodes()) + it.message))
    }

    fun printWarnings(warnings: List<DomainWarning>) {
        for (it in warnings) err.println(OneLine.of("$file: warning: ${it.kind}" + place(it.x, it.y, it.nodes()) + it.message))
    }

    private fun place(x: Double, y: Double, nodes: IntArray): String {
        val numbers = when (nodes.size) {
            0 -> ""
            1 -> ", node ${nodes[0]}"
            else -> ", nodes ${nodes.joinToString(" ")}"
        }
        return " at ($x, $y)$numbers: "
    }
}
