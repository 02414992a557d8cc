package org.trigrid.cli

import org.trigrid.project.InputOptions
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException

/** The options that say how a file becomes a domain: where its boundary nodes lie and what becomes of connectors. */
internal class ExplodingArguments {
    @Option(
        names = ["--spacing"], paramLabel = "S",
        description = [
            "Distance of neighbouring boundary nodes, in the domain's unit, > 0. In a project it takes the place of every " +
                "shape's spacing; the edges of a polygon file, whose nodes are otherwise kept exactly, are exploded again.",
        ],
    )
    var spacing: Double? = null

    @Option(
        names = ["--ratio"], paramLabel = "R",
        description = ["Last spacing / first spacing of each shape or edge, > 0; with --spacing."],
    )
    var ratio: Double? = null

    @Option(
        names = ["--keep-connectors"],
        description = ["Keep the connectors of a project as lines inside the domain. Default: drop them."],
    )
    var keepConnectors: Boolean = false

    /** What was asked for; a spacing or a ratio that cannot be is a usage error. */
    fun toOptions(commandLine: CommandLine): InputOptions {
        val options = InputOptions.DEFAULT.withKeepConnectors(keepConnectors)
        val wanted = spacing
        if (wanted == null) {
            if (ratio != null) throw ParameterException(commandLine, "--ratio needs --spacing")
            return options
        }
        return try {
            options.withSpacing(wanted, ratio ?: 1.0)
        } catch (error: IllegalArgumentException) {
            throw ParameterException(commandLine, "--${error.message}")
        }
    }
}
