package org.trigrid

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.diagnostics.Stage
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck
import org.trigrid.front.FrontListener
import org.trigrid.geometry.Pose
import org.trigrid.mesh.MeshFreezer
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import org.trigrid.numbering.NumberingMetrics
import org.trigrid.quality.QualityReport
import org.trigrid.spacing.ConstrainedDelaunay
import org.trigrid.spacing.SizeFields

/**
 * Makes meshes: checks the domain, finds the sizes, advances the front, improves the mesh and renumbers its nodes.
 *
 * Guarantee: every valid domain gets a valid mesh, in which each given node and segment stands exactly as given and no
 * other node lies on the boundary, on an embedded line or on the interface of two regions. The same input gives the same mesh, to the last bit, on every machine.
 * Exception: a domain whose sizes ask for more elements than [MeshOptions.maxElements], or than Java's heap can hold, is
 * refused before meshing.
 *
 * Stateless and free to be called by several threads at once.
 */
public object MeshGenerator {
    /** As the other, with default options and nobody listening. */
    @JvmStatic
    public fun generate(domain: Domain): MeshResult = generate(domain, MeshOptions.DEFAULT)

    /** As the other, with nobody listening. */
    @JvmStatic
    public fun generate(domain: Domain, options: MeshOptions): MeshResult = generate(domain, options, ProgressMonitor.NONE)

    /**
     * @param monitor hears of the progress and may cancel.
     * @throws InvalidDomainException if the domain has faults; carries all of them with their places.
     * @throws TooManyElementsException if the sizes ask for more elements than the options, or Java's heap, allow.
     * @throws MeshingCancelledException if the monitor cancels.
     */
    @JvmStatic
    public fun generate(domain: Domain, options: MeshOptions, monitor: ProgressMonitor): MeshResult =
        run(domain, options, StageClock(monitor), null)

    /**
     * As the other; the mesh is the same.
     *
     * @param listener hears of each element that the front made, in that order, with its place before the mesh was improved and
     *   renumbered; most often not before the mesh is done.
     */
    @JvmStatic
    public fun generate(domain: Domain, options: MeshOptions, monitor: ProgressMonitor, listener: FrontListener): MeshResult =
        run(domain, options, StageClock(monitor), listener)

    /** As the other, with nobody listening. */
    @JvmStatic
    public fun expectedElements(domain: Domain, options: MeshOptions): Double =
        expectedElements(domain, options, ProgressMonitor.NONE)

    /**
     * About how many elements the mesh would have, good to some 15 % where the domain is wide against its sizes. For planning:
     * takes a fraction of the time of meshing.
     *
     * @throws InvalidDomainException if the domain has faults; carries all of them with their places.
     * @throws MeshingCancelledException if the monitor cancels.
     */
    @JvmStatic
    public fun expectedElements(domain: Domain, options: MeshOptions, monitor: ProgressMonitor): Double {
        val run = StageClock(monitor)
        checkDomain(domain, run)
        run.begin(Stage.SIZES)
        val sizing = Checkpoint(run, Stage.SIZES)
        val triangulation = ConstrainedDelaunay.of(domain.withoutLonePoints(), sizing)
        val sizes = SizeFields.createWithPoints(domain, options.sizeRules(Pose.AS_GIVEN), triangulation, sizing)
        return SizeFields.estimateElements(triangulation, sizes, sizing)
    }

    private fun checkDomain(domain: Domain, run: StageClock) {
        run.begin(Stage.CHECK)
        val faults = DomainCheck.check(domain, Checkpoint(run, Stage.CHECK))
        if (faults.isNotEmpty()) throw InvalidDomainException(faults)
    }

    internal fun run(domain: Domain, options: MeshOptions, run: StageClock, listener: FrontListener?): MeshResult {
        checkDomain(domain, run)
        val made = MeshAttempts(domain, options, run, listener).make()
        val finishing = Checkpoint(run, Stage.RENUMBER)
        val raw = MeshFreezer.freeze(made.mesh, domain, finishing)
        val before = NumberingMetrics.of(raw, finishing)
        val mesh = Numbering.renumber(raw, options.numbering, finishing)
        val after = if (mesh === raw) before else NumberingMetrics.of(mesh, finishing)
        finishing.reach(0.8)
        val quality = QualityReport.of(mesh, finishing, options.crew())
        run.end()

        val report = MeshReport(
            mesh.nodeCount, mesh.elementCount, mesh.boundaryNodeCount, domain.loopCount, made.expectedElements, made.fallbacks,
            quality, before, after, run.seconds,
        )
        return MeshResult(mesh, report)
    }
}
