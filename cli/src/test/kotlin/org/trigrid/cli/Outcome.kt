package org.trigrid.cli

import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Path

/** What one run of the command line left: its exit code and what it printed. */
internal class Outcome(val code: Int, val out: String, val err: String) {
    /** Lines of standard error. */
    val errorLines: List<String> get() = err.lines().filter { it.isNotEmpty() }

    companion object {
        /** Runs `trigrid` with the arguments, paths and all, as their texts. */
        fun of(vararg arguments: Any): Outcome {
            val out = ByteArrayOutputStream()
            val err = ByteArrayOutputStream()
            val texts = arguments.map { if (it is Path) it.toString() else it as String }.toTypedArray()
            val code = run(texts, PrintStream(out, false, Charsets.UTF_8), PrintStream(err, false, Charsets.UTF_8))
            return Outcome(code, out.toString(Charsets.UTF_8), err.toString(Charsets.UTF_8))
        }
    }
}
