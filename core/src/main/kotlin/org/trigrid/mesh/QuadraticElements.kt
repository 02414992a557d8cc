package org.trigrid.mesh

/**
 * Puts nodes into the middles of a mesh's edges. Where a middle on a curve would fold an element or nearly so, it goes back
 * towards the straight middle, as far as is needed.
 */
internal class QuadraticElements(private val mesh: TriMesh, private val middles: EdgeMiddles) {
    private val numbers = EdgeNumbers(mesh)
    private val sides = TaggedSides(mesh)
    private val xy = mesh.xy.copyOf(mesh.xy.size + 2 * numbers.count)

    /** Per tagged edge, steps back to the straight middle; [STEPS] is all the way. */
    private val steps = IntArray(mesh.taggedEdgeCount)

    /** Middles asked for less straight ones, x and y of each tagged edge. */
    private val offsets = DoubleArray(2 * mesh.taggedEdgeCount)

    fun make(): QuadraticMesh {
        require(mesh.nodeCount + numbers.count < Int.MAX_VALUE / 2) { "${mesh.elementCount} elements are too many for middles" }
        placeStraight()
        for (edge in steps.indices) {
            val wanted = middles.middleOf(mesh, edge)
            val m = middle(sides.leftOf(edge))
            for (c in 0..1) {
                require(wanted[c].isFinite()) { "the middle of tagged edge $edge is at (${wanted[0]}, ${wanted[1]})" }
                offsets[2 * edge + c] = wanted[c] - xy[2 * m + c]
                xy[2 * m + c] = wanted[c]
            }
        }
        unfold()
        val edges = IntArray(EDGE_NODES * steps.size) {
            val edge = it / EDGE_NODES
            when (it % EDGE_NODES) {
                0 -> mesh.edgeStart(edge)
                1 -> mesh.edgeEnd(edge)
                else -> middle(sides.leftOf(edge))
            }
        }
        return QuadraticMesh(
            xy, elements(), edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags, mesh.parts, steps.count { it > 0 },
        )
    }

    private fun middle(half: Int) = mesh.nodeCount + numbers.of(half)

    private fun placeStraight() {
        for (half in 0 until 3 * mesh.elementCount) {
            if (!MeshTopology.ownsEdge(half, mesh.neighbours)) continue
            val a = mesh.elements[half]
            val b = mesh.elements[MeshTopology.nextCorner(half)]
            val m = middle(half)
            for (c in 0..1) xy[2 * m + c] = EdgeMiddles.halfway(mesh.xy[2 * a + c], mesh.xy[2 * b + c])
        }
    }

    private fun elements() = IntArray(ELEMENT_NODES * mesh.elementCount) {
        val first = 3 * (it / ELEMENT_NODES)
        val k = it % ELEMENT_NODES
        if (k < 3) mesh.elements[first + k] else middle(first + k - 3)
    }

    /** Straightens curved edges of folded elements step by step, until there are none. */
    private fun unfold() {
        val curved = curvedEdges()
        var suspects = curved.keys.toIntArray()
        while (suspects.isNotEmpty()) {
            val folded = suspects.filter { isFolded(it) && curved.getValue(it).any { edge -> steps[edge] < STEPS } }
            for (edge in folded.flatMap { curved.getValue(it) }.distinct()) straighten(edge)
            // Neighbours across an embedded edge that has moved may fold.
            suspects = if (folded.isEmpty()) IntArray(0) else curved.keys.toIntArray()
        }
    }

    /** The curved edges of each element that has some, by ascending element. */
    private fun curvedEdges(): Map<Int, List<Int>> {
        val result = java.util.TreeMap<Int, MutableList<Int>>()
        for (edge in steps.indices) {
            if (offsets[2 * edge] == 0.0 && offsets[2 * edge + 1] == 0.0) continue
            val left = sides.leftOf(edge)
            for (element in intArrayOf(left / 3, mesh.neighbours[left])) {
                if (element >= 0) result.getOrPut(element) { ArrayList(2) }.add(edge)
            }
        }
        return result
    }

    private fun isFolded(element: Int): Boolean {
        val places = DoubleArray(2 * ELEMENT_NODES)
        for (k in 0 until ELEMENT_NODES) {
            val node = if (k < 3) mesh.elements[3 * element + k] else middle(3 * element + k - 3)
            places[2 * k] = xy[2 * node]
            places[2 * k + 1] = xy[2 * node + 1]
        }
        return !(QuadraticJacobian(places).least() >= LEAST_JACOBIAN * 2 * mesh.area(element))
    }

    private fun straighten(edge: Int) {
        if (steps[edge] == STEPS) return
        steps[edge]++
        val half = sides.leftOf(edge)
        val a = mesh.elements[half]
        val b = mesh.elements[MeshTopology.nextCorner(half)]
        val part = 1 - steps[edge].toDouble() / STEPS
        for (c in 0..1) {
            val straight = EdgeMiddles.halfway(mesh.xy[2 * a + c], mesh.xy[2 * b + c])
            xy[2 * middle(half) + c] = straight + part * offsets[2 * edge + c]
        }
    }

    private companion object {
        const val ELEMENT_NODES = QuadraticMesh.NODES_PER_ELEMENT
        const val EDGE_NODES = QuadraticMesh.NODES_PER_EDGE
        const val STEPS = 16

        /** Least Jacobian allowed on an element, as a part of the one it has with straight edges. */
        const val LEAST_JACOBIAN = 0.1
    }
}
