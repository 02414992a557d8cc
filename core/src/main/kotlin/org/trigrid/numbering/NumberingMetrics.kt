package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** What a node order costs a band or profile solver. */
public class NumberingMetrics internal constructor(
    /** B: largest difference of the numbers of two nodes of an element. */
    @get:JvmName("halfBandwidth") public val halfBandwidth: Int,
    /** Sum over the rows i of i - min(j) + 1, the diagonal counted: entries of the lower profile. */
    @get:JvmName("profile") public val profile: Long,
    @get:JvmName("nodeCount") public val nodeCount: Int,
) {
    /** Bandwidth p + q - 1 by the paper's eqs. (6) to (10); that is 2 B + 1, or 0 without nodes. */
    @get:JvmName("bandwidth")
    public val bandwidth: Int get() = if (nodeCount == 0) 0 else 2 * halfBandwidth + 1

    /** Mean wavefront: the profile per row. NaN without nodes. */
    @get:JvmName("meanWavefront")
    public val meanWavefront: Double get() = profile / nodeCount.toDouble()

    override fun toString(): String = "bandwidth $bandwidth, profile $profile"

    public companion object {
        /** The metrics of a mesh in the order it has. */
        @JvmStatic
        public fun of(mesh: TriMesh): NumberingMetrics = of(mesh, Checkpoint.unheard())

        /** The metrics of a mesh in the order it has. */
        @JvmStatic
        public fun of(mesh: QuadraticMesh): NumberingMetrics {
            val lowest = IntArray(mesh.nodeCount) { it }
            for (element in 0 until mesh.elementCount) {
                var low = mesh.nodeOf(element, 0)
                for (k in 1..5) low = minOf(low, mesh.nodeOf(element, k))
                for (k in 0..5) mesh.nodeOf(element, k).let { lowest[it] = minOf(lowest[it], low) }
            }
            return ofLowest(lowest, Checkpoint.unheard())
        }

        internal fun of(mesh: TriMesh, checkpoint: Checkpoint): NumberingMetrics {
            val lowest = IntArray(mesh.nodeCount) { it }
            val elements = mesh.elements
            for (at in elements.indices step 3) {
                checkpoint.pass()
                val low = minOf(elements[at], minOf(elements[at + 1], elements[at + 2]))
                for (k in at..at + 2) if (low < lowest[elements[k]]) lowest[elements[k]] = low
            }
            return ofLowest(lowest, checkpoint)
        }

        /** The metrics of [graph] in the order that [permutation] gives. */
        @JvmStatic
        public fun of(graph: NodeGraph, permutation: Permutation): NumberingMetrics =
            of(graph, permutation, Checkpoint.unheard())

        internal fun of(graph: NodeGraph, permutation: Permutation, checkpoint: Checkpoint): NumberingMetrics =
            ofNumbers(graph, permutation.newNumbersShared(), checkpoint)

        private fun ofNumbers(graph: NodeGraph, numbers: IntArray, checkpoint: Checkpoint): NumberingMetrics {
            val lowest = IntArray(graph.nodeCount)
            for (node in 0 until graph.nodeCount) {
                checkpoint.pass()
                var low = numbers[node]
                for (k in graph.starts[node] until graph.starts[node + 1]) low = minOf(low, numbers[graph.targets[k]])
                lowest[numbers[node]] = low
            }
            return ofLowest(lowest, checkpoint)
        }

        private fun ofLowest(lowest: IntArray, checkpoint: Checkpoint): NumberingMetrics {
            var widest = 0
            var profile = 0L
            checkpoint.ask()
            for (i in lowest.indices) {
                val width = i - lowest[i]
                widest = maxOf(widest, width)
                profile += width + 1
            }
            return NumberingMetrics(widest, profile, lowest.size)
        }
    }
}
