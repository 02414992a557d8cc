package org.trigrid.cli

import picocli.CommandLine
import picocli.CommandLine.Help.Ansi
import picocli.CommandLine.UnmatchedArgumentException
import java.io.PrintWriter

/** Puts the commands together and decides what their failures print and return. */
internal object CommandLineFactory {
    private const val HELP_WIDTH = 100

    fun create(session: Session): CommandLine {
        val terminal = session.terminal
        return CommandLine(TriGridCommand(session))
            .addSubcommand(MeshCommand(session))
            .addSubcommand(CheckCommand(session))
            .addSubcommand(InfoCommand(session))
            .addSubcommand(PictureCommand(session))
            .addSubcommand(ConvertCommand(session))
            .addSubcommand(RenumberCommand(session))
            .addSubcommand(ImproveCommand(session))
            .addSubcommand(RefineCommand(session))
            .addSubcommand(BenchCommand(session))
            .addSubcommand(EditCommand(session))
            .addSubcommand(CompletionCommand(session))
            .addSubcommand(ManCommand(session))
            .setCaseInsensitiveEnumValuesAllowed(true)
            // A file may be named @plate.wkt.
            .setExpandAtFiles(false)
            .setUsageHelpWidth(HELP_WIDTH)
            .setColorScheme(CommandLine.Help.defaultColorScheme(if (terminal.showsProgress) Ansi.AUTO else Ansi.OFF))
            .setOut(PrintWriter(terminal.out, true))
            .setErr(PrintWriter(terminal.err, true))
            .setParameterExceptionHandler { error, _ -> usageError(error, terminal) }
            .setExecutionExceptionHandler { error, commandLine, _ ->
                if (error is CommandLine.ParameterException) usageError(error, terminal)
                else Failures(terminal.err).report(error, commandLine.commandName)
            }
    }

    /** One line that says what is wrong, one that says where to read on; never the whole help. */
    private fun usageError(error: CommandLine.ParameterException, terminal: Terminal): Int {
        val command = error.commandLine.commandSpec.qualifiedName()
        terminal.err.println("trigrid: " + messageOf(error))
        terminal.err.println("Try '$command --help'.")
        return ExitCodes.USAGE
    }

    private fun messageOf(error: CommandLine.ParameterException): String {
        val strange = (error as? UnmatchedArgumentException)?.takeIf { !it.isUnknownOption }?.unmatched?.firstOrNull()
        val commands = error.commandLine.subcommands.keys
        return when {
            strange == null -> error.message.orEmpty().lines().joinToString("; ") { it.trim() }
            commands.isEmpty() -> "there is nothing to do with '$strange'"
            else -> "there is no command '$strange'; there are ${commands.joinToString()}"
        }
    }
}
