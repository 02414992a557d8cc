package org.trigrid.cli

import picocli.CommandLine.Command
import picocli.CommandLine.HelpCommand
import picocli.CommandLine.IVersionProvider
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec

/** The program itself: it only has subcommands. */
@Command(
    name = "trigrid",
    description = ["Advancing-front triangular meshes of irregular 2D domains."],
    mixinStandardHelpOptions = true,
    versionProvider = TriGridCommand.Version::class,
    subcommands = [HelpCommand::class],
    synopsisSubcommandLabel = "COMMAND",
    footer = [
        "",
        "Examples:",
        "  trigrid mesh plate.trigrid.json -o plate.msh --picture plate.svg",
        "  trigrid check coast.geojson",
        "  trigrid convert plate.msh plate.vtu",
        "  trigrid COMMAND --help",
        "",
        "Exit codes: 0 done, 2 usage, 3 invalid domain, 4 file trouble, 130 cancelled.",
    ],
)
internal class TriGridCommand(private val session: Session) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run() {
        val message = "say what to do: mesh, check, info, picture, convert, renumber, improve, refine or edit"
        throw ParameterException(spec.commandLine(), message)
    }

    /** The version of the jar that runs. */
    class Version : IVersionProvider {
        override fun getVersion(): Array<String> =
            arrayOf("trigrid " + (javaClass.`package`.implementationVersion ?: "(not from a jar)"))
    }
}
