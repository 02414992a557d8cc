package org.trigrid.io

import org.trigrid.mesh.TriMesh

/**
 * The physical groups of a mesh file: a named curve group for each tag that has edges, then one named surface.
 *
 * Ids are above 0 and differ between curves and surface, and so do names: some readers keep one table for all
 * dimensions, and attributes of 0 are refused by others.
 */
internal class MshGroups(mesh: TriMesh) {
    /** Per curve group, the index of its tag in the mesh. */
    val curveTags: IntArray

    /** Per curve group, its number of edges. */
    val curveSizes: IntArray
    val curveNames: List<String>
    val surfaceName: String

    val curveCount: Int get() = curveTags.size
    val surfaceId: Int get() = curveCount + 1

    init {
        val sizes = IntArray(mesh.tags.size)
        for (tag in mesh.edgeTags) sizes[tag]++
        curveTags = sizes.indices.filter { sizes[it] > 0 }.toIntArray()
        curveSizes = IntArray(curveTags.size) { sizes[curveTags[it]] }
        val taken = HashSet<String>()
        curveNames = curveTags.map { unique(safe(mesh.tags[it]), taken) }
        surfaceName = unique(safe(mesh.regionName), taken)
    }

    private fun unique(name: String, taken: MutableSet<String>): String {
        var result = name
        var n = 2
        while (!taken.add(result)) result = "${name.take(LONGEST - 8)}_${n++}"
        return result
    }

    /** Only what every reader takes: ASCII without quotes and brackets, at most 127 characters. */
    private fun safe(name: String): String {
        val text = name.take(LONGEST).map { if (it.code in 32..126 && it !in REFUSED) it else '_' }.joinToString("").trim()
        return text.ifEmpty { "group" }
    }

    private companion object {
        const val LONGEST = 127
        const val REFUSED = "\"'()[]{}\\$"
    }
}
