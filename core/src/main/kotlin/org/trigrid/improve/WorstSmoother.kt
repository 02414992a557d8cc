package org.trigrid.improve

import org.trigrid.quality.TriangleQuality

/** Moves the nodes near bad elements so that the worst of each star becomes as good as can be, at the cost of the others. */
internal class WorstSmoother(
    private val connectivity: Connectivity,
    private val changes: Changes,
    /** A move below this part of the node's size is none. */
    private val tolerance: Double,
) {
    private val mesh = connectivity.mesh
    private val star = Star()

    fun run(progress: ImproveProgress) {
        markBad(progress)
        for (sweep in 0 until SWEEPS) sweep(progress)
    }

    /** Marks the corners of bad elements and their neighbours. */
    private fun markBad(progress: ImproveProgress) {
        val elements = mesh.elements
        val xy = mesh.xy
        for (t in 0 until mesh.elementCount) {
            progress.pass()
            val a = elements[3 * t]
            if (a < 0) continue
            val b = elements[3 * t + 1]
            val c = elements[3 * t + 2]
            val q = TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
            if (q >= BAD) continue
            mark(a)
            mark(b)
            mark(c)
        }
    }

    private fun mark(node: Int) {
        if (!connectivity.isFree(node)) return
        changes.touch(node, Changes.WORST)
        star.gather(connectivity, node)
        for (i in 0 until star.count) changes.touch(star.ring[i], Changes.WORST)
    }

    private fun sweep(progress: ImproveProgress) {
        val count = mesh.nodeCount
        for (n in mesh.fixedNodeCount until count) {
            progress.tick(n, count)
            if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.WORST)) continue
            star.gather(connectivity, n)
            if (star.minQuality() > FAIR || !star.worstFirstStep()) continue
            val dx = star.x - mesh.xy[2 * n]
            val dy = star.y - mesh.xy[2 * n + 1]
            mesh.xy[2 * n] = star.x
            mesh.xy[2 * n + 1] = star.y
            val least = 0.5 * tolerance * mesh.sizes[n]
            if (dx * dx + dy * dy <= least * least) continue
            changes.touch(n, Changes.WORST or Changes.FLIPS)
            for (i in 0 until star.count) changes.touch(star.ring[i], Changes.WORST)
        }
    }

    private companion object {
        const val SWEEPS = 6

        /** Elements below this are to be mended; stars above [FAIR] are left alone. */
        const val BAD = 0.9
        const val FAIR = 0.96
    }
}
