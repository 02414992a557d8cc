package org.trigrid.cli

import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException

/** The option that says how many nodes the elements of a written mesh have. */
class OrderArguments {
    @Option(
        names = ["--order"], paramLabel = "N",
        description = [
            "2: elements of six nodes, the middles of boundary edges on the curves of a project. Default: 1, of three; or that of a mesh " +
                "that is read.",
        ],
    )
    var given: Int? = null

    val order: Int get() = given ?: 1

    /** A number that is no order, or an order that [format] does not have, is a usage error. */
    fun check(format: MeshFormat?, commandLine: CommandLine) {
        if (order !in 1..2) throw ParameterException(commandLine, "--order must be 1 or 2, not $order")
        if (order == 1 || format != null && format.highestOrder >= order) return
        val able = MeshFormats.all().filter { it.highestOrder >= order }.joinToString { it.name }
        throw ParameterException(commandLine, "--order $order is for the formats $able, not ${format?.name ?: "domains"}")
    }
}
