package org.trigrid.improve

/** Moves free nodes one by one to where the sum of 1/q around them is least; those near a node that moves noticeably are due again. */
internal class Smoother(
    private val connectivity: Connectivity,
    private val changes: Changes,
    /** A move below this part of the node's size is none. */
    private val tolerance: Double,
) {
    private val mesh = connectivity.mesh
    private val star = Star()

    /** One sweep over the nodes whose star has changed. */
    fun sweep(progress: ImproveProgress) {
        val count = mesh.nodeCount
        for (n in mesh.fixedNodeCount until count) {
            progress.tick(n, count)
            if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.SMOOTHING)) continue
            star.gather(connectivity, n)
            if (!star.smoothingStep()) continue
            val dx = star.x - mesh.xy[2 * n]
            val dy = star.y - mesh.xy[2 * n + 1]
            mesh.xy[2 * n] = star.x
            mesh.xy[2 * n + 1] = star.y
            val least = tolerance * mesh.sizes[n]
            if (dx * dx + dy * dy <= least * least) continue
            changes.touch(n, Changes.SMOOTHING or Changes.FLIPS)
            for (i in 0 until star.count) changes.touch(star.ring[i], Changes.SMOOTHING)
        }
    }
}
