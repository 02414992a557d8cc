package org.trigrid.cli

import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Path
import java.util.concurrent.Callable

/** The editor is a program of its own, which the launcher starts; this command describes it in the help. */
@Command(
    name = "edit",
    description = ["Open the editor, a window in which domains are drawn and meshed."],
    mixinStandardHelpOptions = true,
    footer = ["", "Example:", "  trigrid edit src-test-data/domains/hand.geojson"],
)
internal class EditCommand(private val session: Session) : Callable<Int> {
    @Parameters(paramLabel = "FILE", arity = "0..1", description = ["A project or a polygon file to open."])
    var file: Path? = null

    override fun call(): Int {
        session.terminal.err.println("trigrid: the editor is started by the launcher, ./trigrid edit, or by editor:run of the Gradle build")
        return ExitCodes.USAGE
    }
}
