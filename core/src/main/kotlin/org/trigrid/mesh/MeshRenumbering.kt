package org.trigrid.mesh

import org.trigrid.diagnostics.Checkpoint

/** Gives the nodes of a mesh new numbers and puts its elements in their order. */
internal object MeshRenumbering {
    fun apply(mesh: TriMesh, newNumbers: IntArray, checkpoint: Checkpoint = Checkpoint.unheard()): TriMesh {
        checkpoint.ask()
        requirePermutation(newNumbers, mesh.nodeCount)
        checkpoint.ask()
        val xy = DoubleArray(mesh.xy.size)
        val kinds = ByteArray(mesh.kinds.size)
        for (node in newNumbers.indices) {
            checkpoint.pass()
            val to = newNumbers[node]
            xy[2 * to] = mesh.xy[2 * node]
            xy[2 * to + 1] = mesh.xy[2 * node + 1]
            kinds[to] = mesh.kinds[node]
        }
        val edges = IntArray(mesh.edges.size) { newNumbers[mesh.edges[it]] }
        val place = elementPlaces(mesh.nodeCount, mesh.elements, 3, newNumbers, checkpoint)
        checkpoint.ask()
        val elements = IntArray(mesh.elements.size)
        val neighbours = IntArray(mesh.neighbours.size)
        for (t in place.indices) {
            checkpoint.pass()
            val from = 3 * t
            val to = 3 * place[t]
            for (k in 0..2) {
                elements[to + k] = newNumbers[mesh.elements[from + k]]
                val neighbour = mesh.neighbours[from + k]
                neighbours[to + k] = if (neighbour < 0) neighbour else place[neighbour]
            }
        }
        return TriMesh(
            xy, elements, neighbours, kinds, edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags,
            mesh.parts.renumbered(newNumbers, place),
        )
    }

    fun apply(mesh: QuadraticMesh, newNumbers: IntArray): QuadraticMesh {
        requirePermutation(newNumbers, mesh.nodeCount)
        val xy = DoubleArray(mesh.xy.size)
        for (at in xy.indices) xy[2 * newNumbers[at / 2] + at % 2] = mesh.xy[at]
        val width = QuadraticMesh.NODES_PER_ELEMENT
        val place = elementPlaces(mesh.nodeCount, mesh.elements, width, newNumbers, Checkpoint.unheard())
        val elements = IntArray(mesh.elements.size)
        for (at in elements.indices) elements[width * place[at / width] + at % width] = newNumbers[mesh.elements[at]]
        val edges = IntArray(mesh.edges.size) { newNumbers[mesh.edges[it]] }
        return QuadraticMesh(
            xy, elements, edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags, mesh.parts.renumbered(newNumbers, place),
            mesh.straightenedEdgeCount,
        )
    }

    /** New place of each element: stable counting sort by the lowest new corner. The corners of an element come first. */
    private fun elementPlaces(
        nodeCount: Int, elements: IntArray, nodesPerElement: Int, newNumbers: IntArray, checkpoint: Checkpoint,
    ): IntArray {
        val place = IntArray(elements.size / nodesPerElement)
        val start = IntArray(nodeCount + 1)
        for (t in place.indices) {
            checkpoint.pass()
            val a = newNumbers[elements[nodesPerElement * t]]
            val b = newNumbers[elements[nodesPerElement * t + 1]]
            val c = newNumbers[elements[nodesPerElement * t + 2]]
            val low = minOf(a, minOf(b, c))
            place[t] = low
            start[low + 1]++
        }
        for (n in 1..nodeCount) start[n] += start[n - 1]
        for (t in place.indices) {
            checkpoint.pass()
            place[t] = start[place[t]]++
        }
        return place
    }

    private fun requirePermutation(newNumbers: IntArray, count: Int) {
        require(newNumbers.size == count) { "${newNumbers.size} new numbers for $count nodes" }
        val seen = BooleanArray(count)
        for (node in newNumbers.indices) {
            val to = newNumbers[node]
            require(to in 0 until count && !seen[to]) { "new number $to of node $node is out of range or given twice" }
            seen[to] = true
        }
    }
}
