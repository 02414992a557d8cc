package org.trigrid.mesh

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.LaidDomain
import org.trigrid.geometry.Predicates

/** Takes the mesh of a domain as it is laid back to the domain as it was given. */
internal object LaidMesh {
    /** Whether all elements are positive, exactly: after a frame, rounding may have folded one of them. */
    fun isPositive(mesh: MutableMesh, checkpoint: Checkpoint): Boolean {
        val xy = mesh.xy
        for (t in 0 until mesh.elementCount) {
            checkpoint.pass()
            val a = 2 * mesh.elements[3 * t]
            val b = 2 * mesh.elements[3 * t + 1]
            val c = 2 * mesh.elements[3 * t + 2]
            if (!(Predicates.orient(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[c], xy[c + 1]) > 0)) return false
        }
        return true
    }

    /** @param mesh changed in place. Nothing else is to be done with it than to freeze it: sizes are not taken back. */
    fun takeBack(mesh: MutableMesh, laid: LaidDomain, given: DoubleArray, checkpoint: Checkpoint) {
        val xy = mesh.xy
        given.copyInto(xy)
        for (node in mesh.fixedNodeCount until mesh.nodeCount) {
            checkpoint.pass()
            val x = xy[2 * node]
            val y = xy[2 * node + 1]
            xy[2 * node] = laid.pose.givenX(x, y)
            xy[2 * node + 1] = laid.pose.givenY(x, y)
        }
        for (i in 0 until 3 * mesh.elementCount) {
            checkpoint.pass()
            mesh.elements[i] = laid.givenNode(mesh.elements[i])
        }
        if (laid.pose.isMirrored) turn(mesh, checkpoint)
    }

    /** Swaps the last two corners of each element, and so its first edge and its last. */
    private fun turn(mesh: MutableMesh, checkpoint: Checkpoint) {
        for (t in 0 until mesh.elementCount) {
            checkpoint.pass()
            swap(mesh.elements, 3 * t + 1, 3 * t + 2)
            swap(mesh.twins, 3 * t, 3 * t + 2)
            for (e in 3 * t..3 * t + 2) {
                val twin = mesh.twins[e]
                if (twin >= 0) mesh.twins[e] = twin + 2 - 2 * (twin % 3)
            }
        }
    }

    private fun swap(values: IntArray, a: Int, b: Int) {
        val kept = values[a]
        values[a] = values[b]
        values[b] = kept
    }
}
