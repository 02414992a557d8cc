package org.trigrid.cli

import org.trigrid.MeshOptions
import org.trigrid.front.Strategy
import org.trigrid.numbering.NumberingMethod
import org.trigrid.spacing.SizeSources
import org.trigrid.spacing.Sizes
import picocli.CommandLine
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import java.io.Serializable

/** The options that say how to mesh, here or on another machine; what is not given stays as the project file says, or at its default. */
class MeshingArguments : Serializable {
    @Option(
        names = ["--sizes"], paramLabel = "MODE",
        description = [
            "smooth: sizes run from the spacing of one boundary to that of the other. grade: they grow from the " +
                "boundary as fast as the gradation lets them. Default: smooth.",
        ],
    )
    var sizes: Sizes? = null

    @Option(
        names = ["--gradation"], paramLabel = "G",
        description = ["Largest change of size per length, > 0. Default: 0.25. Small values make many elements."],
    )
    var gradation: Double? = null

    @Option(names = ["--min-size"], paramLabel = "L", description = ["Smallest size of inner edges, >= 0. Default: 0."])
    var minSize: Double? = null

    @Option(names = ["--max-size"], paramLabel = "L", description = ["Largest size of inner edges, > 0. Default: none."])
    var maxSize: Double? = null

    @Option(
        names = ["--size-source"], paramLabel = "H@X,Y",
        description = [
            "Elements of size H at the place (X, Y), or with more places X,Y,X,Y,... along a line, growing from there by the " +
                "gradation. May be given again; added to those of the project.",
        ],
    )
    var sizeSources: List<String> = emptyList()

    @Option(
        names = ["--strategy"], paramLabel = "NAME",
        description = ["robust, or classic for the paper's own rules. Default: robust."],
    )
    var strategy: Strategy? = null

    @Option(
        names = ["--max-elements"], paramLabel = "N",
        description = ["Make no mesh of more elements, which is told before meshing, > 0. Default: 20000000."],
    )
    var maxElements: Int? = null

    @Option(
        names = ["--threads"], paramLabel = "N",
        description = ["Threads that share the work on a mesh of 150,000 elements or more, > 0; the mesh is the same. Default: 1."],
    )
    var threads: Int? = null

    @Option(names = ["--no-improve"], description = ["Leave the elements as the front made them."])
    var noImprove: Boolean = false

    @Option(names = ["--no-renumber"], description = ["Leave the nodes in the order in which they were made."])
    var noRenumber: Boolean = false

    /** [base] with the options given laid over it; a value out of range is a usage error. */
    fun over(base: MeshOptions, commandLine: CommandLine): MeshOptions = try {
        over(base)
    } catch (error: IllegalArgumentException) {
        throw ParameterException(commandLine, error.message)
    }

    /** As the other. @throws IllegalArgumentException if a value is out of range. */
    fun over(base: MeshOptions): MeshOptions {
        val builder = base.toBuilder()
        sizes?.let { builder.sizes(it) }
        gradation?.let { builder.gradation(it) }
        minSize?.let { builder.minSize(it) }
        maxSize?.let { builder.maxSize(it) }
        if (sizeSources.isNotEmpty()) builder.sizeSources(sizeSources.fold(base.sizeSources, ::withSource))
        strategy?.let { builder.strategy(it) }
        maxElements?.let { builder.maxElements(it) }
        threads?.let { builder.threads(it) }
        if (noImprove) builder.improve(false)
        if (noRenumber) builder.numbering(NumberingMethod.NONE)
        return builder.build()
    }

    private fun withSource(sources: SizeSources, text: String): SizeSources {
        val size = text.substringBefore('@').trim().toDoubleOrNull()
        val place = text.substringAfter('@', "").split(',').map { it.trim().toDoubleOrNull() }
        require(size != null && null !in place && place.size % 2 == 0) { "--size-source must be of the form H@X,Y or H@X,Y,X,Y,..., not $text" }
        val xy = place.filterNotNull().toDoubleArray()
        return if (xy.size == 2) sources.withPoint(size, xy[0], xy[1]) else sources.withLine(size, *xy)
    }

    private companion object {
        private const val serialVersionUID = 1L
    }
}
