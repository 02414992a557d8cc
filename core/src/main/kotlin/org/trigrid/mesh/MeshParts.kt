package org.trigrid.mesh

import org.trigrid.domain.Region

/** The regions of a mesh's elements, and the nodes that were given as points. */
internal class MeshParts(
    val regions: List<Region>,
    /** Per element: index into [regions]; empty where there is one region. Not modified. */
    val elementRegions: IntArray,
    /** Node numbers. Not modified. */
    val points: IntArray,
    /** Per point: index into the mesh's tags. Not modified. */
    val pointTags: IntArray,
) {
    fun regionOf(element: Int): Int = if (elementRegions.isEmpty()) 0 else elementRegions[element]

    /** After new numbers of nodes, and new places of elements. */
    fun renumbered(newNumbers: IntArray, elementPlaces: IntArray): MeshParts {
        val moved = IntArray(elementRegions.size)
        for (t in elementRegions.indices) moved[elementPlaces[t]] = elementRegions[t]
        return MeshParts(regions, moved, IntArray(points.size) { newNumbers[points[it]] }, pointTags)
    }

    companion object {
        fun single(regionName: String): MeshParts =
            MeshParts(java.util.List.of(Region.of(regionName)), IntArray(0), IntArray(0), IntArray(0))
    }
}
