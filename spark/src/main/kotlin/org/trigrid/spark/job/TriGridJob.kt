@file:JvmName("TriGridJob")

package org.trigrid.spark.job

import org.apache.spark.sql.SparkSession
import org.trigrid.cli.ExitCodes
import java.io.PrintStream
import kotlin.system.exitProcess

/**
 * The main class of `trigrid-spark-job.jar`, for `spark-submit`: meshes files of outlines on a cluster. `--help` and
 * `docs/spark.md` tell the options.
 */
public fun main(arguments: Array<String>) {
    val code = runJob(arguments, System.out, System.err) { SparkSession.builder().appName("TriGrid").getOrCreate() }
    // A driver inside of the cluster must not end by System.exit when all is well.
    if (code != ExitCodes.DONE) exitProcess(code)
}

/** What [main] does, in a session that is stopped at the end; returns the exit code. */
internal fun runJob(arguments: Array<String>, out: PrintStream, err: PrintStream, session: () -> SparkSession): Int =
    JobCommand.commandLine(out, err, session).execute(*arguments)
