package org.trigrid.cli

import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Spec
import java.util.concurrent.Callable

/** Prints the manual page. */
@Command(
    name = "man",
    description = ["Print the manual page of all commands, for man and groff."],
    mixinStandardHelpOptions = true,
    footer = ["", "Examples:", "  trigrid man | man -l -", "  trigrid man > ~/.local/share/man/man1/trigrid.1"],
)
internal class ManCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    override fun call(): Int {
        session.terminal.out.print(ManPage.of(spec.root()))
        return ExitCodes.DONE
    }
}

/** A manual page in the language of man(7), made of what the help says. */
internal object ManPage {
    fun of(root: CommandSpec): String = buildString {
        append(".TH TRIGRID 1 \"\" \"").append(root.version().firstOrNull().orEmpty()).append("\" \"User Commands\"\n")
        append(".SH NAME\n").append(text("${root.name()} - ${root.usageMessage().description().joinToString(" ")}")).append('\n')
        append(".SH SYNOPSIS\n.B ").append(root.name()).append("\n.I COMMAND\n[\\fIoptions\\fR]\n")
        append(".SH COMMANDS\n")
        val commands = root.subcommands().values.map { it.commandSpec }.filter { it.name() != "help" }
        for (command in commands) command(command)
        append(".SH EXIT STATUS\n")
        for ((code, meaning) in EXIT) append(".TP\n.B ").append(code).append('\n').append(text(meaning)).append('\n')
    }

    private fun StringBuilder.command(command: CommandSpec) {
        append(".SS ").append(command.qualifiedName())
        for (parameter in command.positionalParameters()) append(' ').append(parameter.paramLabel())
        append('\n').append(text(command.usageMessage().description().joinToString(" "))).append('\n')
        for (parameter in command.positionalParameters()) entry(parameter.paramLabel(), parameter.description())
        for (option in command.options()) {
            if (option.hidden()) continue
            val label = if (option.arity().max() == 0) "" else "=" + option.paramLabel()
            entry(option.names().joinToString(", ") + label, option.description())
        }
        val footer = command.usageMessage().footer().dropWhile { it.isBlank() }
        if (footer.isEmpty()) return
        append(".PP\n.nf\n")
        for (line in footer) append(text(line)).append('\n')
        append(".fi\n")
    }

    private fun StringBuilder.entry(label: String, description: Array<String>) {
        append(".TP\n.B ").append(text(label)).append('\n').append(text(description.joinToString(" "))).append('\n')
    }

    /** Backslashes, hyphens that are to stay hyphens, and dots at the start of a line mean something else in man(7). */
    private fun text(text: String): String {
        val plain = text.replace("\\", "\\e").replace("-", "\\-").replace("°", "\\(de").replace("≥", ">=")
        return if (plain.startsWith(".") || plain.startsWith("'")) "\\&$plain" else plain.ifEmpty { "\\&" }
    }

    private val EXIT = listOf(
        "0" to "done",
        "1" to "a defect of TriGrid itself, or too little memory",
        "2" to "the command line makes no sense",
        "3" to "the domain, a shape of it or the mesh has faults",
        "4" to "a file is missing, cannot be written, or is not what its format asks for",
        "130" to "cancelled",
    )
}
