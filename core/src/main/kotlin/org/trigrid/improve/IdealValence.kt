package org.trigrid.improve

import org.trigrid.geometry.HalfEdges
import org.trigrid.mesh.MutableMesh

/**
 * How many elements should meet at a node: 6 inside, and the angle over 60 degrees at a boundary node. The latter is kept
 * as a real number: at a right angle one element and two are equally good.
 */
internal class IdealValence(mesh: MutableMesh, progress: ImproveProgress) {
    private val fixed = DoubleArray(mesh.fixedNodeCount)

    init {
        val xy = mesh.xy
        for (h in 0 until 3 * mesh.elementCount) {
            progress.pass()
            val a = mesh.elements[h]
            if (a < 0 || a >= fixed.size || mesh.elements[h - h % 3] < 0) continue
            val b = mesh.elements[HalfEdges.next(h)]
            val c = mesh.elements[HalfEdges.previous(h)]
            val ux = xy[2 * b] - xy[2 * a]
            val uy = xy[2 * b + 1] - xy[2 * a + 1]
            val vx = xy[2 * c] - xy[2 * a]
            val vy = xy[2 * c + 1] - xy[2 * a + 1]
            fixed[a] += StrictMath.atan2(ux * vy - uy * vx, ux * vx + uy * vy) / SIXTY_DEGREES
        }
        for (n in fixed.indices) if (fixed[n] < 1) fixed[n] = 1.0
    }

    fun of(node: Int): Double = if (node < fixed.size) fixed[node] else 6.0

    /** Change of the squared deviation from the ideal when the valence goes from [from] to [to]. */
    fun change(node: Int, from: Int, to: Int): Double {
        val ideal = of(node)
        return (to - ideal) * (to - ideal) - (from - ideal) * (from - ideal)
    }

    /**
     * By how much the flip of edge a-b into c-d lowers the sum of the squared deviations; > 0 is good, and whole even
     * numbers unless a boundary node takes part.
     */
    fun flipGain(valence: IntArray, a: Int, b: Int, c: Int, d: Int): Double {
        if (Math.min(Math.min(a, b), Math.min(c, d)) >= fixed.size) return 2.0 * (valence[a] + valence[b] - valence[c] - valence[d] - 2)
        val tooMany = (valence[a] - of(a)) + (valence[b] - of(b))
        val tooFew = (valence[c] - of(c)) + (valence[d] - of(d))
        return 2 * (tooMany - tooFew) - 4
    }

    private companion object {
        const val SIXTY_DEGREES = Math.PI / 3
    }
}
