package org.trigrid.mesh

import org.trigrid.geometry.HalfEdges

/** The arrays of a mesh that is put together from parts. */
internal class JoinedMesh(private val whole: MutableMesh, private val nodes: Int, private val elementCount: Int) {
    // Room for what mending the seams may add: to grow arrays costs half as much again.
    private val xy = whole.xy.copyOf(2 * whole.fixedNodeCount).copyOf(2 * (nodes + nodes / SPARE))
    private val sizes = whole.sizes.copyOf(whole.fixedNodeCount).copyOf(nodes + nodes / SPARE)
    private val elements = IntArray(3 * (elementCount + elementCount / SPARE))
    private val twins = IntArray(elements.size)
    private val seams = MeshSeams()
    private var filled = 0

    fun place(node: Int, fromXy: DoubleArray, fromSizes: DoubleArray, from: Int) {
        xy[2 * node] = fromXy[2 * from]
        xy[2 * node + 1] = fromXy[2 * from + 1]
        sizes[node] = fromSizes[from]
    }

    /** Appends the elements of [part]; its edges between two nodes for which [meets] holds may go on in another part. */
    fun append(part: MutableMesh, newNumber: IntArray, meets: (Int) -> Boolean) {
        for (h in 0 until 3 * part.elementCount) {
            val a = part.elements[h]
            elements[filled + h] = newNumber[a]
            val twin = part.twins[h]
            twins[filled + h] = if (twin < 0) -1 else filled + twin
            if (twin >= 0) continue
            val b = part.elements[HalfEdges.next(h)]
            if (meets(a) && meets(b)) seams.add(newNumber[a], newNumber[b], filled + h)
        }
        filled += 3 * part.elementCount
    }

    /** Makes what was put together the whole. */
    fun takeOver() {
        seams.link(twins)
        whole.xy = xy
        whole.sizes = sizes
        whole.nodeCount = nodes
        whole.elements = elements
        whole.twins = twins
        whole.elementCount = elementCount
    }

    private companion object {
        const val SPARE = 50
    }
}
