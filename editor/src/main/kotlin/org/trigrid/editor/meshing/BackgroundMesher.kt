package org.trigrid.editor.meshing

import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicInteger
import org.trigrid.MeshGenerator
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.TriGridException
import org.trigrid.editor.document.EditorDocument
import org.trigrid.front.FrontTrace
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.NumberingMethod

/** Hears what the background has found; always called through the executor it was given with. */
internal interface MeshListener {
    fun inspected(inspection: DomainInspection)

    /** @param progress null when nothing runs. */
    fun progressed(progress: MeshProgress?)

    fun meshed(view: MeshView)

    /** The run ended without a mesh. @param message what to tell, or null if it was cancelled. */
    fun failed(message: String?)
}

/**
 * Inspects and meshes snapshots of the document away from the window. The latest request counts: an earlier one is
 * cancelled, and what it would have found is not told.
 *
 * @param worker runs the work, one after the other.
 * @param publisher brings findings to the listener's thread.
 */
internal class BackgroundMesher(
    private val worker: Executor,
    private val publisher: Executor,
    private val listener: MeshListener,
) {
    private val latestInspection = AtomicInteger()
    private val latestRun = AtomicInteger()

    fun inspect(document: EditorDocument) {
        val request = latestInspection.incrementAndGet()
        worker.execute {
            if (request != latestInspection.get()) return@execute
            val found = DomainInspection.of(document)
            publisher.execute { if (request == latestInspection.get()) listener.inspected(found) }
        }
    }

    fun mesh(document: EditorDocument) {
        val request = latestRun.incrementAndGet()
        worker.execute { if (request == latestRun.get()) run(document, request) }
    }

    fun cancel() {
        latestRun.incrementAndGet()
        publisher.execute { listener.progressed(null) }
    }

    private fun run(document: EditorDocument, request: Int) = guarded(request) { monitor ->
        val view = generate(document, monitor);
        { listener.meshed(view) }
    }

    /** Does [work] under a monitor and publishes what it returns, unless the request is no longer the latest. */
    private fun guarded(request: Int, work: (ProgressMonitor) -> () -> Unit) {
        val tell = { action: () -> Unit -> publisher.execute { if (request == latestRun.get()) action() } }
        val monitor = ProgressMonitor { stage, fraction ->
            tell { listener.progressed(MeshProgress(stage, fraction)) }
            request == latestRun.get()
        }
        try {
            tell(work(monitor))
        } catch (_: MeshingCancelledException) {
            tell { listener.failed(null) }
        } catch (error: InvalidDomainException) {
            val first = error.faults.firstOrNull()?.message ?: error.message.orEmpty()
            tell { listener.failed("Mend the faults first (F4 lists them): $first") }
        } catch (error: TriGridException) {
            tell { listener.failed(error.message.orEmpty()) }
        } catch (error: RuntimeException) {
            // A mistake of the program's own must not leave the window waiting.
            tell { listener.failed("The mesh could not be made: $error. Save the drawing and report it, please") }
        } catch (_: OutOfMemoryError) {
            tell { listener.failed("There is not enough memory for this mesh; ask for larger elements") }
        }
        tell { listener.progressed(null) }
    }

    private fun generate(document: EditorDocument, monitor: ProgressMonitor): MeshView {
        val options = document.project.options.toBuilder().threads(Runtime.getRuntime().availableProcessors()).build()
        val result = MeshGenerator.generate(document.project.toDomain(), options, monitor)
        return MeshView(document, result.mesh, result.report)
    }

    /** Meshes once more and notes how the front advances; [done] gets the notes, the listener hears what went wrong. */
    fun trace(document: EditorDocument, done: (FrontTrace) -> Unit) {
        val request = latestRun.incrementAndGet()
        worker.execute {
            if (request != latestRun.get()) return@execute
            val project = document.project
            guarded(request) { monitor ->
                val most = Math.min(project.options.maxElements, FrontPlayback.MOST_ELEMENTS)
                val domain = project.toDomain()
                val trace = FrontTrace(domain)
                MeshGenerator.generate(domain, project.options.toBuilder().maxElements(most).build(), monitor, trace);
                { done(trace) }
            }
        }
    }

    /** The mesh of [view] in the numbers that the front gave its nodes; made anew, for the matrix view. */
    fun unnumbered(view: MeshView, done: (TriMesh) -> Unit) {
        val document = view.document ?: return
        worker.execute {
            val options = document.project.options.toBuilder().numbering(NumberingMethod.NONE).build()
            val mesh = try {
                MeshGenerator.generate(document.project.toDomain(), options).mesh
            } catch (_: TriGridException) {
                return@execute
            }
            publisher.execute { done(mesh) }
        }
    }
}
