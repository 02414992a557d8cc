package org.trigrid.cli

import picocli.AutoComplete
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.util.concurrent.Callable

/** Shells for which there is a completion. */
internal enum class Shell { BASH, ZSH, FISH }

/** Prints a script that makes a shell complete the command line. */
@Command(
    name = "completion",
    description = ["Print a script by which bash, zsh or fish complete commands, options and values."],
    mixinStandardHelpOptions = true,
    footer = [
        "",
        "Examples:",
        "  trigrid completion bash > ~/.local/share/bash-completion/completions/trigrid",
        "  trigrid completion zsh > ~/.trigrid.zsh   (and in ~/.zshrc: source ~/.trigrid.zsh)",
        "  trigrid completion fish > ~/.config/fish/completions/trigrid.fish",
    ],
)
internal class CompletionCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "SHELL", description = ["bash, zsh or fish."])
    lateinit var shell: Shell

    override fun call(): Int {
        val root = spec.root()
        val script = if (shell == Shell.FISH) FishCompletion.script(root) else AutoComplete.bash(root.name(), root.commandLine())
        session.terminal.out.print(script)
        return ExitCodes.DONE
    }
}

/** The completion of fish, of the commands and their options. */
internal object FishCompletion {
    fun script(root: CommandSpec): String = buildString {
        append("# Completion of ${root.name()} for fish.\n")
        for ((name, command) in root.subcommands()) {
            line("-n __fish_use_subcommand -f -a $name -d ${quoted(summary(command.commandSpec))}", root)
        }
        for ((name, command) in root.subcommands()) {
            for (option in command.commandSpec.options()) {
                if (option.hidden()) continue
                val names = option.names().joinToString(" ") { if (it.startsWith("--")) "-l ${it.drop(2)}" else "-s ${it.drop(1)}" }
                val values = option.completionCandidates()?.joinToString(" ").orEmpty().lowercase(java.util.Locale.ROOT)
                val value = if (option.arity().max() == 0) "" else if (values.isEmpty()) " -r" else " -x -a ${quoted(values)}"
                line("-n \"__fish_seen_subcommand_from $name\" $names$value -d ${quoted(option.description().joinToString(" "))}", root)
            }
        }
    }

    private fun StringBuilder.line(text: String, root: CommandSpec) {
        append("complete -c ").append(root.name()).append(' ').append(text).append('\n')
    }

    private fun summary(command: CommandSpec) = command.usageMessage().description().joinToString(" ")

    private fun quoted(text: String) = "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
}
