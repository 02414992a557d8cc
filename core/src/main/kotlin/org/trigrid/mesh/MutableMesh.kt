package org.trigrid.mesh

/**
 * The mesh while it is made and improved: growing arrays, no checks. Frozen to a [TriMesh] at the end.
 *
 * A *half-edge* `3 t + k` is edge `k` of element `t`, from its corner `k` to corner `(k + 1) mod 3`. Its twin is the same
 * edge in the neighbouring element, or -1 on the boundary:
 * ```
 *        2
 *       / \        3t   : 0 -> 1      next(3t + k) = 3t + (k + 1) % 3
 *   +2 / t \ +1    3t+1 : 1 -> 2
 *     /_____\      3t+2 : 2 -> 0
 *    0  +0   1
 * ```
 * The nodes `0 until fixedNodeCount` were given and never move or go. Dead elements have `elements[3 t] == -1`, dead
 * nodes have size NaN; [compact] removes both.
 */
internal class MutableMesh(
    /** x0, y0, x1, y1, …; capacity may exceed [nodeCount]. */
    @JvmField var xy: DoubleArray,
    @JvmField val fixedNodeCount: Int,
    /** Wanted edge length per node. */
    @JvmField var sizes: DoubleArray,
    elementCapacity: Int,
    /** Segments inside the domain that must stay edges; empty for most domains. */
    @JvmField val embedded: EdgeSet,
) {
    @JvmField var nodeCount: Int = fixedNodeCount

    /** Three nodes an element, anticlockwise. */
    @JvmField var elements: IntArray = IntArray(3 * elementCapacity)

    /** Twin half-edge of each half-edge, or -1. */
    @JvmField var twins: IntArray = IntArray(3 * elementCapacity)

    @JvmField var elementCount: Int = 0

    fun isFixed(node: Int): Boolean = node < fixedNodeCount

    /** Whether the edge between two nodes is an embedded segment. */
    fun isEmbedded(a: Int, b: Int): Boolean =
        !embedded.isEmpty && a < fixedNodeCount && b < fixedNodeCount && embedded.contains(a, b)

    /** Appends a node and returns its number. */
    fun addNode(x: Double, y: Double, size: Double): Int {
        val node = nodeCount++
        if (2 * node + 1 >= xy.size) {
            xy = xy.copyOf(grown(xy.size))
            sizes = sizes.copyOf(xy.size / 2)
        } else if (node >= sizes.size) {
            sizes = sizes.copyOf(xy.size / 2)
        }
        xy[2 * node] = x
        xy[2 * node + 1] = y
        sizes[node] = size
        return node
    }

    /** Appends an element without twins and returns its number. */
    fun addElement(a: Int, b: Int, c: Int): Int {
        val element = elementCount++
        val at = 3 * element
        if (at + 2 >= elements.size) {
            elements = elements.copyOf(grown(elements.size))
            twins = twins.copyOf(elements.size)
        }
        elements[at] = a
        elements[at + 1] = b
        elements[at + 2] = c
        twins[at] = -1
        twins[at + 1] = -1
        twins[at + 2] = -1
        return element
    }

    /** Makes two half-edges each other's twin; either may be -1. */
    fun link(a: Int, b: Int) {
        if (a >= 0) twins[a] = b
        if (b >= 0) twins[b] = a
    }

    /** Removes dead elements and dead nodes; the order of the others is kept. Calls [pass] for each of them. */
    fun compact(pass: () -> Unit = {}) {
        val newNode = IntArray(nodeCount)
        var nodes = 0
        for (n in 0 until nodeCount) {
            pass()
            if (sizes[n].isNaN()) {
                newNode[n] = -1
                continue
            }
            newNode[n] = nodes
            xy[2 * nodes] = xy[2 * n]
            xy[2 * nodes + 1] = xy[2 * n + 1]
            sizes[nodes++] = sizes[n]
        }
        nodeCount = nodes
        val newElement = IntArray(elementCount)
        var count = 0
        for (t in 0 until elementCount) {
            pass()
            newElement[t] = if (elements[3 * t] < 0) -1 else count++
        }
        for (t in 0 until elementCount) {
            pass()
            val to = newElement[t]
            if (to < 0) continue
            for (k in 0..2) {
                val twin = twins[3 * t + k]
                elements[3 * to + k] = newNode[elements[3 * t + k]]
                twins[3 * to + k] = if (twin < 0) -1 else 3 * newElement[twin / 3] + twin % 3
            }
        }
        elementCount = count
    }

    private fun grown(size: Int): Int {
        // A multiple of 6 keeps whole nodes and whole elements.
        val wanted = size + size / 2 + 96
        return wanted - wanted % 6
    }
}
