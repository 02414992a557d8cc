package org.trigrid.quality

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.MeshTopology
import org.trigrid.mesh.TriMesh

/** How many neighbours the interior nodes of a mesh have. */
internal class NodeDegrees private constructor(
    /** Interior nodes by degree; the last class holds all higher degrees. */
    private val counts: IntArray,
) {
    val interiorNodeCount: Int get() = counts.sum()

    /** Share of interior nodes with a degree in [low]..[high]; NaN without interior nodes. */
    fun share(low: Int, high: Int): Double {
        var some = 0
        for (d in low..high) some += counts[d]
        return some / interiorNodeCount.toDouble()
    }

    companion object {
        private const val CLASSES = 32

        fun of(mesh: TriMesh, checkpoint: Checkpoint): NodeDegrees {
            val degrees = IntArray(mesh.nodeCount)
            val boundary = BooleanArray(mesh.nodeCount)
            val elements = mesh.elements
            for (half in elements.indices) {
                checkpoint.pass()
                // Inside, as many half-edges begin at a node as it has neighbours.
                degrees[elements[half]]++
                if (mesh.neighbours[half] < 0) {
                    boundary[elements[half]] = true
                    boundary[elements[MeshTopology.nextCorner(half)]] = true
                }
            }
            val counts = IntArray(CLASSES)
            for (n in degrees.indices) {
                if (degrees[n] > 0 && !boundary[n]) counts[minOf(degrees[n], CLASSES - 1)]++
            }
            return NodeDegrees(counts)
        }
    }
}
