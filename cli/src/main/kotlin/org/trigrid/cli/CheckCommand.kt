package org.trigrid.cli

import org.trigrid.domain.DomainCheck
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Mixin
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Path
import java.util.concurrent.Callable

/** Tells all that keeps a domain from being meshed. */
@Command(
    name = "check",
    description = ["List everything that keeps a domain from being meshed, one line a fault, and mesh nothing."],
    mixinStandardHelpOptions = true,
    sortOptions = false,
    footer = ["", "Example:", "  trigrid check coast.geojson", "", "Exit code 0 without faults, 3 with."],
)
internal class CheckCommand(private val session: Session) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Parameters(paramLabel = "IN", description = ["A project (.trigrid.json), GeoJSON, WKT or Triangle .poly file."])
    lateinit var input: Path

    @Mixin
    lateinit var arguments: ExplodingArguments

    override fun call(): Int {
        arguments.check(spec.commandLine())
        var isFaulty = false
        for (domain in DomainInput.read(input, arguments)) {
            val faults = DomainCheck.check(domain.domain)
            if (faults.isEmpty()) {
                session.terminal.out.println("$input: ${domain.describe()}, no faults")
            } else {
                isFaulty = true
                Failures(session.terminal.err).faults(faults, input.toString())
            }
        }
        return if (isFaulty) ExitCodes.INVALID_DOMAIN else ExitCodes.DONE
    }
}
