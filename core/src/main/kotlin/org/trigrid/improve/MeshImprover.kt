package org.trigrid.improve

import org.trigrid.mesh.MutableMesh

/**
 * Turns the raw mesh of the front into a good one: rounds of surgery led by the valences with smoothing in between,
 * trials led by the quality, and a care for the worst elements at the end.
 *
 * Fixed nodes, boundary segments and embedded ones stay as they are; every element stays positive. The sizes at the
 * mesh's nodes steer lengths and count. Deterministic, and blind to the scale of the coordinates.
 */
internal class MeshImprover(
    private val mesh: MutableMesh,
    /** Smoothing takes a move below this part of the node's size for none. */
    tolerance: Double,
    /** Hears of the progress, from 0 to 1, and may throw to end the work. */
    report: (Double) -> Unit = {},
) {
    private val progress = ImproveProgress(report)
    private val connectivity = Connectivity(mesh, progress)
    private val changes = Changes(mesh)
    private val ideal = IdealValence(mesh, progress)
    private val flipper = Flipper(connectivity, ideal, changes)
    private val collapser = Collapser(connectivity, ideal, changes, flipper)
    private val splitter = Splitter(connectivity, ideal, changes, flipper)
    private val smoother = Smoother(connectivity, changes, tolerance)
    private val trials = PatchTrials(connectivity, ideal, changes, splitter)
    private val worst = WorstSmoother(connectivity, changes, tolerance)

    /**
     * Improves the mesh and compacts it.
     *
     * @param changed nodes to begin with, if the mesh has been improved before; null for all.
     */
    fun run(changed: IntArray? = null) {
        progress.stage(0.05)
        if (changed == null) changes.touchAll() else for (node in changed) changes.touch(node)
        flipper.runChanged(progress)
        for (round in 0 until ROUNDS) mendValences()
        tryPatches()
        // Where the first pass has changed little, as in wide parts of even size, a second one changes next to nothing.
        smoother.sweep(progress)
        if (trials.kept > mesh.elementCount / OFTEN) tryPatches()
        flipper.byQuality = true
        progress.stage(0.15)
        if (changed == null) flipper.runAll(progress) else flipper.runChanged(progress)
        smoother.sweep(progress)
        // The share of nodes that lie near given ones is large here, and the sweep is cheap.
        if (mesh.elementCount < SMALL) smoother.sweep(progress)
        for (round in 0 until WORST_ROUNDS) {
            progress.stage(0.04)
            worst.run(progress)
            flipper.runChanged(progress)
        }
        mesh.compact { progress.pass() }
        progress.finish()
    }

    private fun mendValences() {
        progress.stage(0.12)
        val count = mesh.nodeCount
        for (n in mesh.fixedNodeCount until count) {
            progress.tick(n, count)
            if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.SURGERY) || connectivity.isRegular(n)) continue
            if (collapser.tryNode(n) || splitter.tryNode(n)) flipper.run(progress)
        }
        progress.stage(0.05)
        smoother.sweep(progress)
    }

    private fun tryPatches() {
        changes.beginTrials()
        progress.stage(0.10)
        trials.tryLengths(progress)
        progress.stage(0.11)
        trials.tryFlips(progress)
    }

    private companion object {
        const val ROUNDS = 2
        const val WORST_ROUNDS = 2

        /** Meshes of fewer elements get a second sweep at the end. */
        const val SMALL = 20_000

        /** Kept trials, one in so many elements, after which there is another pass. */
        const val OFTEN = 50
    }
}
