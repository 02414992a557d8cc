package org.trigrid.cli

import org.trigrid.MeshOptions
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.picture.Picture
import org.trigrid.project.DomainInput
import org.trigrid.project.DomainInputs
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Draws a domain, or its mesh, or a mesh that is there already. */
@Command(
    name = "picture",
    description = ["Draw a domain, the mesh made of it, or a mesh file."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = [
        "",
        "Examples:",
        "  trigrid picture plate.trigrid.json -o plate.svg --show domain",
        "  trigrid picture plate.msh -o quality.png --show quality --pixels 3000",
        "",
        "A file with several polygons makes as many pictures: FILE-1.svg, FILE-2.svg, ...",
    ],
)
internal class PictureCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A file with a domain, which is meshed first, or a mesh file."])
    lateinit var input: Path

    @Option(names = ["-o", "--output"], paramLabel = "FILE", required = true, description = ["The picture: .svg or .png."])
    lateinit var output: Path

    @Option(
        names = ["--show"], paramLabel = "WHAT",
        description = [
            "mesh: the elements. domain: the boundary nodes as donuts, numbered as by 'check'. numbers: of nodes and " +
                "elements, as in the mesh file. quality: elements coloured by it. matrix: structure of the coefficient " +
                "matrix, before and after renumbering. Default: mesh.",
        ],
    )
    var show: PictureContent = PictureContent.MESH

    @Option(names = ["--pixels"], paramLabel = "N", description = ["Longer side of a .png, 16 to 30000. Default: 1600."])
    var pixels: Int = PictureOutput.DEFAULT_PIXELS

    @Mixin
    lateinit var exploding: ExplodingArguments

    @Mixin
    lateinit var inner: InnerArguments

    @Mixin
    lateinit var meshing: MeshingArguments

    override fun call(): Int {
        val inputOptions = inner.over(exploding.toOptions(spec.commandLine()), spec.commandLine())
        checkArguments()
        if (MeshInput.isMesh(input)) {
            PictureOutput.write(show.of(MeshInput.readEither(input).corners, null), output, pixels)
            return ExitCodes.DONE
        }
        val inputs = InputFailure.naming(input) { DomainInputs.read(input, inputOptions) }
        inputs.forEachIndexed { i, domain ->
            PictureOutput.write(draw(domain), NumberedFiles.name(output, i, inputs.size), pixels)
        }
        return ExitCodes.DONE
    }

    private fun checkArguments() {
        val commandLine = spec.commandLine()
        meshing.over(MeshOptions.DEFAULT, commandLine)
        PictureOutput.checkName(output, commandLine)
        if (pixels !in PIXELS) throw ParameterException(commandLine, "--pixels must be from ${PIXELS.first} to ${PIXELS.last}")
        if (show == PictureContent.DOMAIN && MeshInput.isMesh(input)) {
            throw ParameterException(commandLine, "--show domain needs a domain, not a mesh file")
        }
        OutputPlace.check(output)
        OutputPlace.checkApart(listOf("the input" to input, "the picture" to output), commandLine)
    }

    private fun draw(given: DomainInput): Picture {
        if (show == PictureContent.DOMAIN) return PictureContent.ofDomain(given.domain)
        val options = meshing.over(given.options, spec.commandLine())
        val made = DomainMesher(session, input)
            .mesh(given.domain, options.toBuilder().numbering(NumberingMethod.NONE).build()).mesh
        val renumbered = if (options.numbering == NumberingMethod.NONE) made else Numbering.renumber(made, options.numbering)
        return show.of(renumbered, made)
    }

    private companion object {
        val PIXELS = 16..30_000
    }
}
