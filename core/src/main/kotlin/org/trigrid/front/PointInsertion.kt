package org.trigrid.front

import org.trigrid.domain.SegmentTree
import org.trigrid.geometry.HalfEdges.next
import org.trigrid.geometry.HalfEdges.previous
import org.trigrid.geometry.Predicates
import org.trigrid.mesh.MutableMesh

/**
 * Puts given nodes of no segment into a finished mesh. A free node near by gives way to the given one where the elements round
 * it allow, so that the mesh keeps its pattern; else the element or the edge that the node lies on is divided.
 *
 * Exact: every element stays positive.
 */
internal class PointInsertion(private val mesh: MutableMesh) {
    private var last = 0

    /** @param nodes fixed ones that no element has yet, inside of the mesh, on no segment. */
    fun insert(nodes: IntRange) {
        if (nodes.isEmpty()) return
        val tree = elementBoxes()
        var replaced = false
        for (node in nodes) {
            var near = -1
            tree.forEachIn(mesh.xy[2 * node], mesh.xy[2 * node + 1], mesh.xy[2 * node], mesh.xy[2 * node + 1]) { t ->
                if ((near < 0 || t < near) && isIn(t, node)) near = t
            }
            val element = if (near >= 0) near else find(node)
            if (replace(element, node)) replaced = true else divide(element, node)
            last = element
        }
        if (replaced) mesh.compact()
    }

    /** A segment from corner to corner of each element's box, as they are before the first node comes. */
    private fun elementBoxes(): SegmentTree {
        val corners = DoubleArray(4 * mesh.elementCount) { i ->
            val first = mesh.xy[2 * mesh.elements[3 * (i / 4)] + (i and 1)]
            val second = mesh.xy[2 * mesh.elements[3 * (i / 4) + 1] + (i and 1)]
            val third = mesh.xy[2 * mesh.elements[3 * (i / 4) + 2] + (i and 1)]
            if (i and 2 == 0) Math.min(first, Math.min(second, third)) else Math.max(first, Math.max(second, third))
        }
        return SegmentTree(corners, IntArray(2 * mesh.elementCount) { it })
    }

    /** Where earlier nodes have changed the elements: a walk, and if that leads astray a look at all of them. */
    private fun find(node: Int): Int {
        var t = last
        for (step in 0 until MOST_STEPS) {
            val beyond = (3 * t..3 * t + 2).firstOrNull { side(it, node) < 0 && mesh.twins[it] >= 0 } ?: break
            t = mesh.twins[beyond] / 3
        }
        return if (isIn(t, node)) t else (0 until mesh.elementCount).first { isIn(it, node) }
    }

    private fun isIn(t: Int, node: Int): Boolean = (3 * t..3 * t + 2).all { side(it, node) >= 0 }

    private fun side(half: Int, node: Int): Double = orient(mesh.elements[half], mesh.elements[next(half)], node)

    /** Whether a free corner of the element could give way to [node]. */
    private fun replace(element: Int, node: Int): Boolean {
        val corners = (3 * element..3 * element + 2).filter { !mesh.isFixed(mesh.elements[it]) }
            .sortedBy { squaredDistance(mesh.elements[it], node) }
        for (half in corners) {
            val around = around(half)
            // A free node in the very same place must go, whatever its elements are like.
            val isSame = isSamePlace(mesh.elements[half], node)
            if (!isSame && !around.all { isGood(node, mesh.elements[next(it)], mesh.elements[previous(it)]) }) continue
            mesh.sizes[mesh.elements[half]] = Double.NaN
            for (h in around) mesh.elements[h] = node
            return true
        }
        return false
    }

    /** The half-edges that leave the free node at which [half] begins. */
    private fun around(half: Int): List<Int> {
        val result = ArrayList<Int>(8)
        var h = half
        do {
            result.add(h)
            h = mesh.twins[previous(h)]
        } while (h != half)
        return result
    }

    private fun isGood(a: Int, b: Int, c: Int): Boolean {
        val twiceArea = orient(a, b, c)
        if (!(twiceArea > 0)) return false
        val squares = squaredDistance(a, b) + squaredDistance(b, c) + squaredDistance(c, a)
        return 2 * SQRT_3 * twiceArea >= LEAST_QUALITY * squares
    }

    private fun divide(element: Int, node: Int) {
        val on = (3 * element..3 * element + 2).firstOrNull { side(it, node) == 0.0 }
        if (on != null) divideEdge(on, node) else divideElement(element, node)
    }

    private fun divideElement(t: Int, node: Int) {
        val a = mesh.elements[3 * t]
        val b = mesh.elements[3 * t + 1]
        val c = mesh.elements[3 * t + 2]
        val beyondB = mesh.twins[3 * t + 1]
        val beyondC = mesh.twins[3 * t + 2]
        val u = 3 * mesh.addElement(b, c, node)
        val v = 3 * mesh.addElement(c, a, node)
        mesh.elements[3 * t + 2] = node
        mesh.link(u, beyondB)
        mesh.link(v, beyondC)
        mesh.link(3 * t + 1, u + 2)
        mesh.link(u + 1, v + 2)
        mesh.link(v + 1, 3 * t + 2)
    }

    /** The inner edge a-b of the elements (a, b, c) and (b, a, d) becomes a-node and node-b, joined to c and d. */
    private fun divideEdge(h: Int, node: Int) {
        val g = mesh.twins[h]
        val a = mesh.elements[h]
        val b = mesh.elements[g]
        val c = mesh.elements[previous(h)]
        val d = mesh.elements[previous(g)]
        val beyondH = mesh.twins[next(h)]
        val beyondG = mesh.twins[next(g)]
        val t = 3 * mesh.addElement(node, b, c)
        val s = 3 * mesh.addElement(node, a, d)
        mesh.elements[next(h)] = node
        mesh.elements[next(g)] = node
        mesh.link(h, s)
        mesh.link(g, t)
        mesh.link(t + 1, beyondH)
        mesh.link(s + 1, beyondG)
        mesh.link(next(h), t + 2)
        mesh.link(next(g), s + 2)
    }

    private fun orient(a: Int, b: Int, c: Int): Double {
        val xy = mesh.xy
        return Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
    }

    private fun isSamePlace(a: Int, b: Int): Boolean = mesh.xy[2 * a] == mesh.xy[2 * b] && mesh.xy[2 * a + 1] == mesh.xy[2 * b + 1]

    private fun squaredDistance(a: Int, b: Int): Double {
        val dx = mesh.xy[2 * b] - mesh.xy[2 * a]
        val dy = mesh.xy[2 * b + 1] - mesh.xy[2 * a + 1]
        return dx * dx + dy * dy
    }

    private companion object {
        const val MOST_STEPS = 10_000
        const val SQRT_3 = 1.7320508075688772

        /** Below this it is better to divide an element than to bend those round a node so far. */
        const val LEAST_QUALITY = 0.3
    }
}
