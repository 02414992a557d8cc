package org.trigrid.improve

/** Moves free nodes one by one to where the sum of 1/q around them is least, as long as they move noticeably. */
internal class Smoother(
    private val connectivity: Connectivity,
    private val changes: Changes,
    /** A move below this part of the node's size is none. */
    private val tolerance: Double,
) {
    private val mesh = connectivity.mesh
    private val star = Star()

    /** One sweep over the nodes whose star changed; returns how many moved. */
    fun sweep(): Int {
        var moved = 0
        for (n in mesh.fixedNodeCount until mesh.nodeCount) {
            if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.SMOOTHING)) continue
            star.gather(connectivity, n)
            val oldX = star.x
            val oldY = star.y
            if (!star.newtonStep()) continue
            mesh.xy[2 * n] = star.x
            mesh.xy[2 * n + 1] = star.y
            val dx = star.x - oldX
            val dy = star.y - oldY
            val limit = tolerance * mesh.sizes[n]
            if (dx * dx + dy * dy <= limit * limit) continue
            moved++
            changes.touch(n, Changes.SMOOTHING)
            for (i in 0 until star.count) changes.touch(star.ring[i], Changes.SMOOTHING)
        }
        return moved
    }

    fun worst(limit: Double, sweeps: Int) {
        val elements = mesh.elements
        val xy = mesh.xy
        for (t in 0 until mesh.elementCount) {
            val a = elements[3 * t]
            if (a < 0) continue
            val b = elements[3 * t + 1]
            val c = elements[3 * t + 2]
            if (org.trigrid.quality.TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]) < limit) {
                mark(a)
                mark(b)
                mark(c)
            }
        }
        for (sweep in 0 until sweeps) {
            for (n in mesh.fixedNodeCount until mesh.nodeCount) {
                if (connectivity.outgoing[n] < 0 || !changes.take(n, Changes.WORST)) continue
                star.gather(connectivity, n)
                if (star.minQuality(star.x, star.y) > limit + 0.1) continue
                val oldX = star.x
                val oldY = star.y
                if (!star.steepStep()) continue
                mesh.xy[2 * n] = star.x
                mesh.xy[2 * n + 1] = star.y
                val dx = star.x - oldX
                val dy = star.y - oldY
                val limit = 0.5 * tolerance * mesh.sizes[n]
                if (dx * dx + dy * dy <= limit * limit) continue
                changes.touch(n, Changes.WORST)
                for (i in 0 until star.count) changes.touch(star.ring[i], Changes.WORST)
            }
        }
    }

    private fun mark(n: Int) {
        changes.touch(n, Changes.WORST)
        if (!connectivity.isFree(n)) return
        star.gather(connectivity, n)
        for (i in 0 until star.count) changes.touch(star.ring[i], Changes.WORST)
    }
}
