package org.trigrid.numbering

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** Finds new numbers for the nodes of a graph, part by part where it falls into several. */
internal object Renumbering {
    /**
     * @param boundaryNodes nodes on the boundary, walk by walk in their order; a node may occur more than once.
     */
    fun order(graph: NodeGraph, boundaryNodes: IntArray, method: NumberingMethod, checkpoint: Checkpoint = Checkpoint.unheard()): Permutation {
        if (method == NumberingMethod.NONE || graph.nodeCount == 0) return Permutation.identity(graph.nodeCount)
        val order = IntArray(graph.nodeCount)
        var size = 0
        for (part in GraphParts.of(graph, boundaryNodes, checkpoint)) {
            for (local in partOrder(part, method, checkpoint)) {
                checkpoint.pass()
                order[size++] = part.nodes[local]
            }
        }
        checkpoint.ask()
        val found = Permutation.ofOrder(order)
        if (method == NumberingMethod.CUTHILL_MCKEE) return found
        checkpoint.ask()
        val given = Permutation.identity(graph.nodeCount)
        return if (isBetter(NumberingMetrics.of(graph, found, checkpoint), NumberingMetrics.of(graph, given, checkpoint))) found else given
    }

    /** Lower half-bandwidth first, then lower profile. */
    private fun isBetter(a: NumberingMetrics, b: NumberingMetrics): Boolean =
        a.halfBandwidth < b.halfBandwidth || a.halfBandwidth == b.halfBandwidth && a.profile < b.profile

    private fun partOrder(part: GraphPart, method: NumberingMethod, checkpoint: Checkpoint): IntArray {
        val entries = part.graph.targets.size.toLong()
        return when (method) {
            NumberingMethod.CUTHILL_MCKEE -> PaperNumbering.order(part.graph, part.boundary, checkpoint)
            else -> {
                OrderSearch(part.graph, part.boundary, maxOf(SMALL_BUDGET, PASSES * entries), checkpoint).search()
            }
        }
    }

    /** The boundary nodes of a mesh, walk after walk; where walks touch, a node occurs once. */
    fun boundaryWalks(mesh: TriMesh, checkpoint: Checkpoint = Checkpoint.unheard()): IntArray {
        val next = IntArray(mesh.nodeCount) { TriMesh.NONE }
        for (e in 0 until mesh.boundaryEdgeCount) {
            checkpoint.pass()
            next[mesh.edgeStart(e)] = mesh.edgeEnd(e)
        }
        return walks(next, mesh.boundaryEdgeCount, checkpoint) { mesh.edgeStart(it) }
    }

    /** As for a [TriMesh], with the middles between their ends. */
    fun boundaryWalks(mesh: QuadraticMesh): IntArray {
        val next = IntArray(mesh.nodeCount) { TriMesh.NONE }
        for (e in 0 until mesh.boundaryEdgeCount) {
            next[mesh.edgeStart(e)] = mesh.edgeMiddle(e)
            next[mesh.edgeMiddle(e)] = mesh.edgeEnd(e)
        }
        return walks(next, mesh.boundaryEdgeCount, Checkpoint.unheard()) { mesh.edgeStart(it) }
    }

    /** @param next the node after each on its walk, -1 for others; all are -1 afterwards. */
    private inline fun walks(next: IntArray, edgeCount: Int, checkpoint: Checkpoint, start: (Int) -> Int): IntArray {
        val walks = IntArray(next.count { it >= 0 })
        var count = 0
        for (e in 0 until edgeCount) {
            checkpoint.pass()
            var node = start(e)
            while (next[node] >= 0) {
                walks[count++] = node
                val to = next[node]
                next[node] = TriMesh.NONE
                node = to
            }
        }
        return walks.copyOf(count)
    }

    /** Passes over a large graph allowed in a search, and the work that any graph may have, in entries read. */
    private const val PASSES = 10L
    private const val SMALL_BUDGET = 2_000_000L
}
