package org.trigrid.io

import org.trigrid.mesh.TriMesh

/**
 * The groups of a mesh file: a named curve group for each tag that has edges, then the named regions, then a named group for
 * each tag that has points.
 *
 * Ids are above 0 and differ between groups of all dimensions, and so do names: some readers keep one table for all
 * dimensions, and attributes of 0 are refused by others. A region's id is its material number where that is its own.
 */
internal class MeshGroups(private val mesh: FileMesh, rule: GroupNames = GroupNames.MSH) {
    /** Per curve group, the index of its tag in the mesh. */
    val curveTags: IntArray
    val curveNames: List<String>
    val regionNames: List<String>

    /** Per point group, the index of its tag in the mesh. */
    val pointTags: IntArray
    val pointNames: List<String>

    private val curveIds: IntArray
    private val regionIds: IntArray
    private val pointIds: IntArray

    /** Per region the number of its material, or one above 0 that no other has. */
    private val materials: IntArray

    /** Tagged edges by group, in their order; those of group i begin at starts[i]. */
    private val edges: IntArray
    private val starts: IntArray

    constructor(mesh: TriMesh, rule: GroupNames = GroupNames.MSH) : this(FileMesh.of(mesh), rule)

    val curveCount: Int get() = curveTags.size
    val regionCount: Int get() = regionNames.size
    val pointGroupCount: Int get() = pointTags.size

    /** Groups of all dimensions. */
    val count: Int get() = curveCount + regionCount + pointGroupCount

    init {
        val sizes = IntArray(mesh.tags.size)
        for (tag in mesh.edgeTags) sizes[tag]++
        curveTags = sizes.indices.filter { sizes[it] > 0 }.toIntArray()
        val groupOfTag = IntArray(sizes.size)
        starts = IntArray(curveTags.size + 1)
        for ((i, tag) in curveTags.withIndex()) {
            groupOfTag[tag] = i
            starts[i + 1] = starts[i] + sizes[tag]
        }
        val place = starts.copyOf()
        edges = IntArray(mesh.taggedEdgeCount)
        for (edge in edges.indices) edges[place[groupOfTag[mesh.edgeTags[edge]]]++] = edge
        pointTags = (0 until mesh.pointCount).map { mesh.pointTag(it) }.distinct().sorted().toIntArray()
        val namer = rule.namer()
        curveNames = curveTags.map { namer.name(mesh.tags[it]) }
        regionNames = mesh.regions.map { namer.name(it.name) }
        pointNames = pointTags.map { namer.name(mesh.tags[it]) }

        val given = mesh.regions.map { it.material }
        val free = FreeNumbers(given)
        curveIds = IntArray(curveCount) { free.next() }
        regionIds = IntArray(regionCount) { r -> if (given[r] > 0 && given.indexOf(given[r]) == r) given[r] else free.next() }
        pointIds = IntArray(pointGroupCount) { free.next() }
        materials = Materials.of(mesh.regions)
    }

    fun curveId(curve: Int): Int = curveIds[curve]

    fun regionId(region: Int): Int = regionIds[region]

    fun pointId(group: Int): Int = pointIds[group]

    fun material(region: Int): Int = materials[region]

    /** Points of a point group. */
    fun points(group: Int): IntArray = (0 until mesh.pointCount).filter { mesh.pointTag(it) == pointTags[group] }.toIntArray()

    /** Nodes of a point group, ascending. */
    fun pointNodes(mesh: FileMesh, group: Int): IntArray =
        points(group).map { mesh.pointNode(it) }.distinct().sorted().toIntArray()

    /** The point group of a point. */
    fun groupOfPoint(point: Int): Int = pointTags.binarySearch(mesh.pointTag(point))

    /** Elements of a region, ascending. */
    fun elements(region: Int): IntArray =
        if (regionCount == 1) IntArray(mesh.elementCount) { it }
        else (0 until mesh.elementCount).filter { mesh.regionOf(it) == region }.toIntArray()

    /** Edges of a curve group. */
    fun size(curve: Int): Int = starts[curve + 1] - starts[curve]

    /** A tagged edge of a curve group, [index] from 0 until [size]. */
    fun edge(curve: Int, index: Int): Int = edges[starts[curve] + index]

    /** Nodes on a curve group, ascending. */
    fun nodes(mesh: FileMesh, curve: Int): IntArray {
        val width = mesh.nodesPerEdge
        val nodes = IntArray(width * size(curve)) { mesh.nodeOn(edge(curve, it / width), it % width) }
        nodes.sort()
        var count = 0
        for (i in nodes.indices) if (i == 0 || nodes[i] != nodes[i - 1]) nodes[count++] = nodes[i]
        return nodes.copyOf(count)
    }
}

/** What names of groups a format takes. */
internal class GroupNames(
    private val longest: Int,
    private val ignoresCase: Boolean,
    private val accepts: (Char) -> Boolean,
    private val needsLetterFirst: Boolean = false,
    /** Names that the format's writer needs itself, in upper case where case does not count. */
    private val reserved: Set<String> = emptySet(),
) {
    fun namer(): Namer = Namer()

    /** Makes names of one file fit, and different from each other. */
    inner class Namer {
        private val taken = HashSet(reserved)

        fun name(wanted: String): String {
            val base = clean(wanted)
            var result = base
            var n = 2
            while (!taken.add(if (ignoresCase) result.uppercase(java.util.Locale.ROOT) else result)) {
                result = "${base.take(longest - 8)}_${n++}"
            }
            return result
        }
    }

    private fun clean(name: String): String {
        val text = name.take(longest).map { if (it.code in 32..126 && accepts(it)) it else '_' }.joinToString("").trim()
        return when {
            text.isEmpty() -> "group"
            needsLetterFirst && !text[0].isLetter() -> ("g_$text").take(longest)
            else -> text
        }
    }

    companion object {
        private const val REFUSED = "\"'()[]{}\\$"

        /** What every reader of Gmsh's files takes: ASCII without quotes and brackets, at most 127 characters. */
        val MSH = GroupNames(127, ignoresCase = false, { it !in REFUSED })

        /** Letters, digits, - and _ only, told apart without case; CalculiX takes 80 characters less a suffix of its own. */
        val ABAQUS = GroupNames(
            64, ignoresCase = true, { it.isLetterOrDigit() || it == '_' || it == '-' }, needsLetterFirst = true, setOf("NALL"),
        )

        /** Without blanks, for formats whose words end at them. */
        val WORD = GroupNames(127, ignoresCase = false, { it.isLetterOrDigit() || it in "_-.+" })
    }
}
