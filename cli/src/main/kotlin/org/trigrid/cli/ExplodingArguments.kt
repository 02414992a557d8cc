package org.trigrid.cli

import org.trigrid.io.CurveDivision
import org.trigrid.io.LengthUnit
import org.trigrid.project.InputOptions
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException

/** The options that say how a file becomes a domain: where its boundary nodes lie and what becomes of connectors. */
class ExplodingArguments {
    @Option(
        names = ["--spacing"], paramLabel = "S",
        description = [
            "Distance of neighbouring boundary nodes, in the domain's unit, > 0. In a project it takes the place of every " +
                "shape's spacing; the edges of a polygon file, whose nodes are otherwise kept exactly, are exploded again, and " +
                "so are the curves of a drawing.",
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

    @Option(
        names = ["--join"], paramLabel = "D",
        description = ["In a DXF drawing, ends no farther from each other are one, >= 0. Default: a millionth of its size."],
    )
    var join: Double? = null

    @Option(
        names = ["--unit"], paramLabel = "U",
        description = ["Unit of the coordinates of a DXF drawing that tells its own: um, mm, cm, dm, m, km, in, ft, mi."],
    )
    var unit: String? = null

    /** What was asked for; a spacing or a ratio that cannot be is a usage error. */
    fun toOptions(commandLine: CommandLine): InputOptions {
        if (spacing == null && ratio != null) throw ParameterException(commandLine, "--ratio needs --spacing")
        val lengthUnit = unit?.let {
            val symbols = LengthUnit.entries.joinToString { unit -> unit.symbol }
            LengthUnit.ofSymbol(it) ?: throw ParameterException(commandLine, "--unit must be one of $symbols, not $it")
        }
        return try {
            var division = CurveDivision.DEFAULT.withUnit(lengthUnit)
            spacing?.let { division = division.withSpacing(it, ratio ?: 1.0) }
            join?.let { division = division.withJoin(it) }
            InputOptions.DEFAULT.withKeepConnectors(keepConnectors).withDivision(division)
        } catch (error: IllegalArgumentException) {
            throw ParameterException(commandLine, "--${error.message}")
        }
    }
}
