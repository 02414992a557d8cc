package org.trigrid.cli

import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.project.DomainInput
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import java.io.IOException

/** The option that says how many nodes the elements of a written mesh have. */
class OrderArguments {
    @Option(
        names = ["--order"], paramLabel = "N",
        description = [
            "2: elements of six nodes, the middles of boundary edges on the curves of a project. Default: that of the project or mesh " +
                "that is read, else 1, of three.",
        ],
    )
    var given: Int? = null

    val order: Int get() = given ?: 1

    /**
     * The order of the mesh of [input]: that of the command line, else the file's own.
     *
     * @throws IOException if [format] does not have it.
     */
    internal fun of(input: DomainInput, format: MeshFormat): Int {
        val order = given ?: input.order
        if (order > format.highestOrder) throw IOException("the project asks for elements of six nodes, which ${format.name} does not have; --order 1 makes those of three")
        return order
    }

    /** A number that is no order, or an order that [format] does not have, is a usage error. */
    fun check(format: MeshFormat?, commandLine: CommandLine) {
        if (order !in 1..2) throw ParameterException(commandLine, "--order must be 1 or 2, not $order")
        if (order == 1 || format != null && format.highestOrder >= order) return
        val able = MeshFormats.all().filter { it.highestOrder >= order }.joinToString { it.name }
        throw ParameterException(commandLine, "--order $order is for the formats $able, not ${format?.name ?: "domains"}")
    }
}
