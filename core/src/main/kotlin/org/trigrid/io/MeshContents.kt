package org.trigrid.io

import org.trigrid.domain.Region
import org.trigrid.geometry.IntList
import org.trigrid.mesh.MeshParts
import org.trigrid.mesh.TriMeshFactory

/** Tells that a file is not what its format asks for, with the place where its reader is. */
internal fun interface Complaint {
    /** @throws org.trigrid.diagnostics.FileFormatException always. */
    fun fail(reason: String): Nothing
}

/**
 * What was read of a mesh file, whatever its format, until it is made a mesh.
 *
 * @param curveWord names groups of edges without a name of their own, with their number; [regionWord] those of triangles.
 */
internal class MeshContents(
    private val complaint: Complaint,
    private val curveWord: String = "curve ",
    private val regionWord: String = "surface ",
) {
    /** Names of groups by dimension and id. */
    private val names = HashMap<Long, String>()
    private var nodeIds = IntArray(0)
    private var xy = DoubleArray(0)
    private var nodeCount = 0
    private val lines = IntList()
    private val lineGroups = IntList()
    private val triangles = IntList()
    private val triangleGroups = IntList()

    /** Between the corners of each triangle; empty where triangles have three nodes. */
    private val middles = IntList()
    private val points = IntList()
    private val pointGroups = IntList()

    /** Nodes in the order of the file, by their id. */
    private var index: NodeIndex? = null

    fun putName(dimension: Int, id: Int, name: String) {
        names[key(dimension, id)] = name
    }

    fun expectNodes(count: Int) {
        nodeIds = IntArray(count)
        xy = DoubleArray(2 * count)
    }

    /** Reserves the next node for [id]. */
    fun addNode(id: Int): Int {
        if (nodeCount == nodeIds.size) complaint.fail("more nodes than the $nodeCount that were announced")
        nodeIds[nodeCount] = id
        return nodeCount++
    }

    fun place(node: Int, x: Double, y: Double, z: Double) {
        if (z != 0.0) complaint.fail("the node has z = $z: only meshes in the plane z = 0 can be read")
        xy[2 * node] = x
        xy[2 * node + 1] = y
    }

    fun closeNodes() {
        if (nodeCount < nodeIds.size) complaint.fail("${nodeIds.size} nodes were announced, $nodeCount were found")
        val found = NodeIndex(nodeIds)
        if (found.duplicate >= 0) complaint.fail("the node id ${found.duplicate} is given twice")
        index = found
    }

    /** The node of an id of the file. */
    fun nodeOf(id: Int): Int {
        val node = index?.find(id) ?: -1
        if (node < 0) complaint.fail("there is no node with the id $id")
        return node
    }

    /** Adds an edge between nodes of the group [group], 0 for none. */
    fun addLine(a: Int, b: Int, group: Int) {
        lines.add(a)
        lines.add(b)
        lineGroups.add(group)
    }

    /** Adds a triangle of the region [group], 0 for none. */
    fun addTriangle(a: Int, b: Int, c: Int, group: Int) {
        triangles.add(a)
        triangles.add(b)
        triangles.add(c)
        triangleGroups.add(group)
    }

    /** Adds a point that is a node, of the group [group]; 0, for none, is no point that anybody asks for. */
    fun addPoint(node: Int, group: Int) {
        if (group == 0) return
        points.add(node)
        pointGroups.add(group)
    }

    /** Gives the triangle added last the nodes between its corners, from the one between the first two on. */
    fun addMiddles(first: Int, second: Int, third: Int) {
        middles.add(first)
        middles.add(second)
        middles.add(third)
    }

    fun toMesh(): ReadMesh {
        if (triangles.size == 0) complaint.fail("the file has no triangles")
        if (middles.size > 0 && middles.size != triangles.size) complaint.fail("the file has triangles of three nodes and of six")
        val quadratic = if (middles.size == 0) null else QuadraticContents(xy.copyOf(), triangles, middles, complaint)
        val newNumbers = IntArray(nodeCount) { -1 }
        for (i in 0 until triangles.size) newNumbers[triangles[i]] = 0
        var used = 0
        for (node in 0 until nodeCount) {
            if (newNumbers[node] < 0) continue
            xy[2 * used] = xy[2 * node]
            xy[2 * used + 1] = xy[2 * node + 1]
            newNumbers[node] = used++
        }
        val groups = (0 until lineGroups.size).map { lineGroups[it] }.distinct()
        val keptPoints = (0 until points.size).filter { newNumbers[points[it]] >= 0 }
        val tags = (groups.map { nameOf(1, it) } + keptPoints.map { nameOf(0, pointGroups[it]) }).distinct()
        val tagNumbers = tags.withIndex().associate { it.value to it.index }
        val tagOfGroup = groups.associateWith { tagNumbers.getValue(nameOf(1, it)) }
        val lineNodes = IntArray(lines.size) { newNumbers[lines[it]] }
        for (node in lineNodes) if (node < 0) complaint.fail("a line has a node that is in no triangle")
        val lineTags = IntArray(lineGroups.size) { tagOfGroup.getValue(lineGroups[it]) }
        val elements = IntArray(triangles.size) { newNumbers[triangles[it]] }
        val pointNodes = IntArray(keptPoints.size) { newNumbers[points[keptPoints[it]]] }
        val pointTags = IntArray(keptPoints.size) { tagNumbers.getValue(nameOf(0, pointGroups[keptPoints[it]])) }
        try {
            val corners = TriMeshFactory.of(xy.copyOf(2 * used), elements, lineNodes, lineTags, tags, parts(pointNodes, pointTags))
            return ReadMesh(corners, quadratic?.toMesh(corners, newNumbers))
        } catch (e: IllegalArgumentException) {
            complaint.fail(e.message ?: "the elements make no mesh")
        }
    }

    /** Regions by their names, in the order of the file; where there are several, the groups' ids are their materials. */
    private fun parts(pointNodes: IntArray, pointTags: IntArray): MeshParts {
        val groups = (0 until triangleGroups.size).map { triangleGroups[it] }.distinct()
        val names = groups.map { regionName(it) }.distinct()
        if (names.size == 1) return MeshParts(listOf(Region.of(names[0])), IntArray(0), pointNodes, pointTags)
        val materials = names.map { name -> groups.first { name == regionName(it) } }
        val regions = names.indices.map { Region.of(names[it]).withMaterial(materials[it]) }
        val regionOfGroup = groups.associateWith { names.indexOf(regionName(it)) }
        val elementRegions = IntArray(triangleGroups.size) { regionOfGroup.getValue(triangleGroups[it]) }
        return MeshParts(java.util.List.copyOf(regions), elementRegions, pointNodes, pointTags)
    }

    private fun word(dimension: Int) = when (dimension) {
        0 -> "point "
        1 -> curveWord
        else -> regionWord
    }

    private fun regionName(group: Int): String = if (group == 0) Region.DEFAULT_NAME else nameOf(2, group)

    private fun nameOf(dimension: Int, group: Int): String = when {
        group == 0 -> TriMeshFactory.UNNAMED
        else -> names[key(dimension, group)] ?: (word(dimension) + group)
    }

    private fun key(dimension: Int, id: Int): Long = (dimension.toLong() shl 32) or (id.toLong() and 0xFFFFFFFFL)

    companion object {
        /** Gmsh's numbers of the kinds of elements. */
        const val LINE = 1
        const val TRIANGLE = 2
        const val QUADRATIC_LINE = 8
        const val QUADRATIC_TRIANGLE = 9
        const val POINT = 15
    }
}
