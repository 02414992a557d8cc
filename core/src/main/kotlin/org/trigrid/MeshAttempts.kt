package org.trigrid

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.MeshingCancelledException
import org.trigrid.diagnostics.Stage
import org.trigrid.diagnostics.TooManyElementsException
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainFrame
import org.trigrid.domain.LaidDomain
import org.trigrid.front.FrontListener
import org.trigrid.front.FrontMesher
import org.trigrid.front.FrontResult
import org.trigrid.front.LaidListener
import org.trigrid.front.Strategy
import org.trigrid.improve.MeshImprovement
import org.trigrid.mesh.LaidMesh
import org.trigrid.mesh.MutableMesh
import org.trigrid.spacing.ConstrainedDelaunay
import org.trigrid.spacing.SizeFields

/** The mesh of a valid domain from the sizes to the improvement: in the domain's own frame where that can be, else as it lies. */
internal class MeshAttempts(
    private val domain: Domain,
    private val options: MeshOptions,
    private val run: StageClock,
    private val listener: FrontListener?,
) {
    fun make(): MadeMesh {
        run.begin(Stage.SIZES)
        val sizing = Checkpoint(run, Stage.SIZES)
        // The paper's rule goes round the boundary as it was given.
        if (options.strategy == Strategy.CLASSIC) return asLaid(LaidDomain.asGiven(domain), sizing)
        return inFrame(sizing) ?: asLaid(LaidDomain.of(domain, sizing), sizing)
    }

    private fun inFrame(sizing: Checkpoint): MadeMesh? {
        // A user's function is asked at places exactly within the domain: it may know no others.
        if (options.sizeFunction != null) return null
        for (frame in DomainFrame(domain, sizing).frames()) {
            val laid = LaidDomain.inFrame(domain, frame, sizing)
            val triangulation = FrameSafety(laid, frame, sizing).triangulation()
            if (triangulation != null) return attempt(laid, triangulation, sizing)
        }
        return null
    }

    private fun asLaid(laid: LaidDomain, sizing: Checkpoint): MadeMesh {
        val triangulation = ConstrainedDelaunay.of(laid.domain.withoutLonePoints(), sizing)
        return checkNotNull(attempt(laid, triangulation, sizing)) { "a mesh was folded on its way back" }
    }

    /** Null if the mesh cannot go back from its frame. */
    private fun attempt(laid: LaidDomain, triangulation: ConstrainedDelaunay, sizing: Checkpoint): MadeMesh? {
        sizing.reach(0.4)
        val sizes = SizeFields.createWithPoints(laid.domain, options.sizeRules(laid.pose), triangulation, sizing)
        sizing.reach(0.7)
        val expected = SizeFields.estimateElements(triangulation, sizes, sizing)
        val refusal = WorkLimit(expected, domain.nodeCount).refusal(options.maxElements, Runtime.getRuntime().maxMemory())
        if (refusal != null) throw TooManyElementsException(refusal)

        run.begin(Stage.FRONT)
        val told = listener?.let { LaidListener(laid, domain, it) }
        val raw = FrontMesher.mesh(laid.domain, sizes, options.strategy, expected, run, told)
        run.begin(Stage.IMPROVE)
        if (options.improve) improve(raw)

        run.begin(Stage.RENUMBER)
        val finishing = Checkpoint(run, Stage.RENUMBER)
        LaidMesh.takeBack(raw.mesh, laid, domain.xy, finishing)
        if (laid.pose.frame != null && !LaidMesh.isPositive(raw.mesh, finishing)) {
            run.begin(Stage.SIZES)
            return null
        }
        told?.tellAll(finishing)
        return MadeMesh(raw.mesh, expected, raw.fallbacks)
    }

    private fun improve(raw: FrontResult) {
        MeshImprovement.improve(raw.mesh, options.strategy, options.smoothingTolerance, options.crew()) {
            if (!run.update(Stage.IMPROVE, it)) throw MeshingCancelledException()
        }
    }
}

/** A mesh that is to be frozen and numbered. */
internal class MadeMesh(
    /** In the given places and node numbers. */
    val mesh: MutableMesh,
    val expectedElements: Double,
    /** As in [FrontResult]. */
    val fallbacks: Int,
)
