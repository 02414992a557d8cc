@file:JvmName("Main")

package org.trigrid.cli

import java.io.PrintStream
import kotlin.system.exitProcess

/** Runs the command line and ends the process with its exit code. */
fun main(arguments: Array<String>) {
    // Pictures are drawn without a display, also where one is there.
    System.setProperty("java.awt.headless", "true")
    val cancellation = Cancellation()
    cancellation.listenToInterrupts()
    val terminal = Terminal.ofProcess()
    val code = try {
        run(arguments, terminal, cancellation)
    } finally {
        cancellation.runHasEnded()
    }
    exitProcess(code)
}

/**
 * Runs one command and returns its exit code, one of [ExitCodes]; what `main` does, without ending the process.
 *
 * @param arguments as typed after `trigrid`.
 * @param out results asked for: reports, figures, help.
 * @param err faults, one a line.
 */
fun run(arguments: Array<String>, out: PrintStream, err: PrintStream): Int =
    run(arguments, Terminal(out, err, showsProgress = false), Cancellation())

internal fun run(arguments: Array<String>, terminal: Terminal, cancellation: Cancellation): Int = try {
    val code = CommandLineFactory.create(Session(terminal, cancellation)).execute(*arguments)
    val trouble = terminal.trouble()
    if (trouble == null) {
        code
    } else {
        terminal.err.println("standard output: $trouble")
        if (code == ExitCodes.DONE) ExitCodes.FILE_TROUBLE else code
    }
} catch (_: OutOfMemoryError) {
    terminal.err.println("trigrid: not enough memory; give more with TRIGRID_JAVA_OPTS=-Xmx8g or the like")
    ExitCodes.DEFECT
} finally {
    terminal.flush()
}
