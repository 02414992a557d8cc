package org.trigrid.mesh

/** Numbers for the edges of a mesh, from 0, in the order of elements. */
internal class EdgeNumbers(mesh: TriMesh) {
    private val numbers = IntArray(3 * mesh.elementCount)
    val count: Int

    init {
        var next = 0
        for (half in numbers.indices) if (MeshTopology.ownsEdge(half, mesh.neighbours)) numbers[half] = next++
        for (half in numbers.indices) if (!MeshTopology.ownsEdge(half, mesh.neighbours)) numbers[half] = numbers[twinOf(mesh, half)]
        count = next
    }

    /** Number of the edge that [half] is one side of. */
    fun of(half: Int): Int = numbers[half]

    private fun twinOf(mesh: TriMesh, half: Int): Int {
        val other = 3 * mesh.neighbours[half]
        return (other..other + 2).first { mesh.elements[it] == mesh.elements[MeshTopology.nextCorner(half)] }
    }
}
