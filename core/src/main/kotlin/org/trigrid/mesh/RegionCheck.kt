package org.trigrid.mesh

/** Checks that each element has a region and that different regions meet at tagged edges only. */
internal class RegionCheck(private val mesh: TriMesh, private val found: ViolationList) {
    fun check() {
        val numbers = mesh.parts.elementRegions
        if (numbers.isEmpty()) return
        if (numbers.size != mesh.elementCount) {
            found.add(
                MeshViolationKind.WRONG_REGION, Double.NaN, Double.NaN, "${mesh.elementCount} elements have ${numbers.size} regions",
            )
            return
        }
        for (t in numbers.indices) {
            if (numbers[t] !in mesh.regions.indices) found.atElement(MeshViolationKind.WRONG_REGION, t, "has no region: ${numbers[t]}")
        }
        val tagged = HashSet<Long>()
        for (edge in mesh.boundaryEdgeCount until mesh.taggedEdgeCount) tagged.add(key(mesh.edgeStart(edge), mesh.edgeEnd(edge)))
        for (half in mesh.neighbours.indices) {
            val across = mesh.neighbours[half]
            if (across < half / 3 || numbers[across] == numbers[half / 3]) continue
            val a = mesh.elements[half]
            val b = mesh.elements[MeshTopology.nextCorner(half)]
            if (key(a, b) !in tagged) found.atEdge(MeshViolationKind.WRONG_REGION, a, b, "parts two regions and has no tag")
        }
    }

    private fun key(a: Int, b: Int): Long = (minOf(a, b).toLong() shl 32) or maxOf(a, b).toLong()
}
