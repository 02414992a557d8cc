package org.trigrid.cli

import picocli.CommandLine.Command
import java.util.concurrent.Callable

@Command(name = "picture", mixinStandardHelpOptions = true, footer = ["  trigrid picture "])
internal class PictureCommand(private val session: Session) : Callable<Int> {
    override fun call(): Int = session.hashCode()
}
