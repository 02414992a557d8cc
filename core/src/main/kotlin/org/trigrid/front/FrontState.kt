package org.trigrid.front

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.mesh.EdgeSet
import org.trigrid.mesh.MutableMesh
import org.trigrid.spacing.SizeField

/** What a run of the front works on: the growing mesh, the front with its index, and the sizes. */
internal class FrontState(domain: Domain, val sizes: SizeField, expectedElements: Double, checkpoint: Checkpoint) {
    /** Where the size field should start its search near each node. */
    private var hints = IntArray(domain.nodeCount) { sizes.hintOf(it) }

    val mesh: MutableMesh
    val index: FrontIndex
    val front: Front
    val acceptance: Acceptance
    val wayOut: VisibleNode

    /**
     * Past this many nodes no more are made and the front is closed with those it has: a bound on the work where the
     * sizes asked for cannot be met between the given nodes.
     */
    val nodeBudget: Int

    init {
        val nodes = domain.nodeCount
        val nodeSizes = DoubleArray(nodes) {
            checkpoint.pass()
            sizes.sizeAt(domain.x(it), domain.y(it), hints[it])
        }
        checkpoint.ask()
        val capacity = (1.1 * expectedElements).toInt() + 2 * nodes + 16
        val xy = domain.xy.copyOf(2 * nodes + capacity)
        checkpoint.ask()
        mesh = MutableMesh(xy, nodes, nodeSizes, capacity, embeddedEdges(domain))
        checkpoint.ask()
        nodeBudget = (nodes + BUDGET * (expectedElements + nodes)).toInt()
        var x0 = Double.POSITIVE_INFINITY
        var y0 = Double.POSITIVE_INFINITY
        var x1 = Double.NEGATIVE_INFINITY
        var y1 = Double.NEGATIVE_INFINITY
        for (node in 0 until nodes) {
            checkpoint.pass()
            x0 = Math.min(x0, domain.x(node))
            x1 = Math.max(x1, domain.x(node))
            y0 = Math.min(y0, domain.y(node))
            y1 = Math.max(y1, domain.y(node))
        }
        index = FrontIndex(x0, y0, x1, y1)
        front = FrontBuilder(domain, mesh, index, checkpoint).build()
        acceptance = Acceptance(mesh, front, index)
        wayOut = VisibleNode(mesh, front, index, acceptance, Math.max(x1 - x0, y1 - y0), checkpoint)
    }

    /** Wanted edge length at a place near [node]. */
    fun sizeNear(node: Int, x: Double, y: Double): Double = sizes.sizeAt(x, y, hints[node])

    /** Adds an interior node near [neighbour]. */
    fun addNode(neighbour: Int, x: Double, y: Double): Int {
        val size = sizes.sizeAt(x, y, hints[neighbour])
        val node = mesh.addNode(x, y, size)
        if (node >= hints.size) hints = hints.copyOf(mesh.xy.size / 2)
        hints[node] = sizes.lastHint
        return node
    }

    private fun embeddedEdges(domain: Domain): EdgeSet {
        val embedded = (0 until domain.segmentCount).filter { domain.isEmbedded(it) }
        if (embedded.isEmpty()) return EdgeSet.EMPTY
        return EdgeSet(IntArray(2 * embedded.size) {
            val segment = embedded[it / 2]
            if (it % 2 == 0) domain.segmentStart(segment) else domain.segmentEnd(segment)
        })
    }

    private companion object {
        /** Nodes allowed for each expected element: about four times what is expected. */
        const val BUDGET = 2.0
    }
}
