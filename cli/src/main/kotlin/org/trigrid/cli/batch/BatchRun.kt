package org.trigrid.cli.batch

import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.cli.ExitCodes
import org.trigrid.cli.Failures
import org.trigrid.cli.Figures
import org.trigrid.cli.MeshFigures
import org.trigrid.cli.NumberedFiles
import org.trigrid.cli.OrderArguments
import org.trigrid.cli.OrderedMesh
import org.trigrid.cli.OutputPlace
import org.trigrid.cli.ReportJson
import org.trigrid.cli.RunClock
import org.trigrid.cli.Session
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.io.MeshFormat
import org.trigrid.project.DomainInput
import org.trigrid.project.DomainInputs
import org.trigrid.project.InputOptions
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.PrintStream
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.Executors
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit

/** How a batch is to be done. */
internal class BatchPlan(
    val inputOptions: InputOptions,
    val format: MeshFormat,
    val ordering: OrderArguments,
    val jobs: Int,
    /** What is left as it is. */
    val made: MadeMeshes,
    /** The options of a domain, by those of its file. */
    val options: (MeshOptions) -> MeshOptions,
)

/** Meshes many files in this process by several threads, and goes on when one fails. The meshes do not depend on how many threads. */
internal class BatchRun(
    private val session: Session,
    private val plan: BatchPlan,
    private val files: List<BatchFile>,
    private val log: BatchLog,
) {
    private val progress = BatchProgress(session.terminal, files.size)
    private val fingerprint = Fingerprint(plan.inputOptions, plan.format, plan.ordering.given ?: 0)
    private val inputs = files.map { OutputPlace.placeOf(it.input) }.toSet()
    private val codes = ConcurrentHashMap.newKeySet<Int>()

    /** @return the exit code: of the worst that happened, a defect before a bad file before a faulty domain. */
    fun run(): Int {
        val pool = Executors.newFixedThreadPool(plan.jobs)
        // Files are not read far ahead, as their domains take memory.
        val slots = Semaphore(AHEAD * plan.jobs)
        try {
            for (file in files) {
                if (session.cancellation.isRequested) break
                // The digest first: a file that is changed meanwhile is then meshed again.
                val digest = attempt(file, null, 1.0) { InputDigest.of(file.input) } ?: continue
                val domains = attempt(file, null, 1.0) { DomainInputs.read(file.input, plan.inputOptions) } ?: continue
                for (i in domains.indices) {
                    slots.acquire()
                    pool.execute {
                        try {
                            mesh(file, digest, domains, i)
                        } finally {
                            slots.release()
                        }
                    }
                }
            }
        } finally {
            pool.shutdown()
            pool.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS)
            progress.close()
        }
        return if (session.cancellation.isRequested) ExitCodes.CANCELLED else SEVERITY.firstOrNull { it in codes } ?: ExitCodes.DONE
    }

    fun summary(): String {
        val skipped = if (progress.skipped > 0) "${progress.skipped} there already, " else ""
        return "${progress.meshes} meshes of ${files.size} files, ${progress.elements} elements, $skipped${progress.failed} failed, " +
            Figures.seconds(progress.seconds)
    }

    private fun mesh(file: BatchFile, digest: InputDigest, domains: List<DomainInput>, index: Int) {
        val share = 1.0 / domains.size
        if (session.cancellation.isRequested) return
        val given = domains[index]
        val output = NumberedFiles.name(file.output, index, domains.size)
        val options = plan.options(given.options)
        val made = fingerprint.of(digest, options)
        if (plan.made.has(output, plan.format, made)) return progress.skip(share)
        val clock = RunClock()
        attempt(file, given.name, share) {
            checkNoInput(output)
            val order = plan.ordering.of(given, plan.format)
            val result = MeshGenerator.generate(given.domain, options) { _, _ -> !session.cancellation.isRequested }
            val ordered = clock.ordering { OrderedMesh.of(result.mesh, order, options.numbering, given::middles) }
            clock.writing {
                output.toAbsolutePath().parent?.let { Files.createDirectories(it) }
                ordered.write(output, plan.format)
            }
            val written = MadeMeshes.writtenAt(output, plan.format)
            log.write(ReportJson.line(file.input, output, made, written, MeshFigures(given.name, result.report, clock, ordered.quadratic)))
            progress.done(share, result.mesh.elementCount)
        }
    }

    /** A format may share its endings with one of domains. */
    private fun checkNoInput(output: Path) {
        for (place in plan.format.filesOf(output)) {
            if (OutputPlace.placeOf(place) in inputs) throw FileSystemException(place.toString(), null, "an input, which the mesh would take the place of")
        }
    }

    /** Does [work]; what goes wrong is told and counted, and null returned. */
    private fun <T> attempt(file: BatchFile, name: String?, share: Double, work: () -> T): T? = try {
        work()
    } catch (_: MeshingCancelledException) {
        null
    } catch (error: Exception) {
        val text = ByteArrayOutputStream()
        val code = PrintStream(text, false, Charsets.UTF_8).use { Failures(it).report(error, file.input.toString()) }
        failed(file, name, share, code, text.toString(Charsets.UTF_8))
    } catch (_: OutOfMemoryError) {
        val advice = "use fewer --jobs, or TRIGRID_JAVA_OPTS=-Xmx8g or the like"
        failed(file, name, share, ExitCodes.DEFECT, "${file.input}: not enough memory; $advice\n")
    }

    private fun <T> failed(file: BatchFile, name: String?, share: Double, code: Int, lines: String): T? {
        codes.add(code)
        try {
            log.write(ReportJson.failure(file.input, name, code, lines.lineSequence().first().removePrefix("${file.input}: ")))
        } catch (_: IOException) {
            // A report that cannot be written is told for the first mesh that it should have had.
        }
        progress.fail(share, lines)
        return null
    }

    private companion object {
        const val AHEAD = 2
        val SEVERITY = listOf(ExitCodes.DEFECT, ExitCodes.FILE_TROUBLE, ExitCodes.INVALID_DOMAIN)
    }
}
