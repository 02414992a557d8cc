package org.trigrid.mesh

import org.trigrid.geometry.InsertionOrder

/**
 * Brings nodes and elements that lie near each other near each other in memory.
 *
 * The front makes them layer by layer, all boundaries of the domain in turn; what goes over a large mesh again and again
 * would wait for memory most of the time.
 */
internal object MeshLocality {
    /** Below this number of elements a mesh fits the caches and keeps the order in which it was made. */
    const val LARGE: Int = 20_000

    /** Orders free nodes along a Hilbert curve, after the fixed ones, and elements by the first of their nodes on it. */
    @JvmStatic
    fun arrange(mesh: MutableMesh) {
        val curve = InsertionOrder.alongCurve(mesh.xy, mesh.nodeCount)
        val rank = IntArray(mesh.nodeCount)
        for (i in curve.indices) rank[curve[i]] = i
        val newElement = elementPlaces(mesh, rank)
        var next = mesh.fixedNodeCount
        val newNode = rank
        for (node in curve) newNode[node] = if (mesh.isFixed(node)) node else next++
        moveNodes(mesh, newNode)
        moveElements(mesh, newNode, newElement)
    }

    private fun elementPlaces(mesh: MutableMesh, rank: IntArray): IntArray {
        val elements = mesh.elements
        val firstRank = IntArray(mesh.elementCount) {
            Math.min(rank[elements[3 * it]], Math.min(rank[elements[3 * it + 1]], rank[elements[3 * it + 2]]))
        }
        val starts = IntArray(mesh.nodeCount + 1)
        for (r in firstRank) starts[r + 1]++
        for (r in 1 until starts.size) starts[r] += starts[r - 1]
        for (t in firstRank.indices) firstRank[t] = starts[firstRank[t]]++
        return firstRank
    }

    private fun moveNodes(mesh: MutableMesh, newNode: IntArray) {
        val xy = DoubleArray(2 * mesh.nodeCount)
        val sizes = DoubleArray(mesh.nodeCount)
        for (node in newNode.indices) {
            val to = newNode[node]
            xy[2 * to] = mesh.xy[2 * node]
            xy[2 * to + 1] = mesh.xy[2 * node + 1]
            sizes[to] = mesh.sizes[node]
        }
        mesh.xy = xy
        mesh.sizes = sizes
    }

    private fun moveElements(mesh: MutableMesh, newNode: IntArray, newElement: IntArray) {
        val elements = IntArray(3 * mesh.elementCount)
        val twins = IntArray(3 * mesh.elementCount)
        for (t in newElement.indices) {
            val to = 3 * newElement[t]
            for (k in 0..2) {
                val twin = mesh.twins[3 * t + k]
                elements[to + k] = newNode[mesh.elements[3 * t + k]]
                twins[to + k] = if (twin < 0) -1 else 3 * newElement[twin / 3] + twin % 3
            }
        }
        mesh.elements = elements
        mesh.twins = twins
    }
}
