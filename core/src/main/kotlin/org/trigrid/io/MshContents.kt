package org.trigrid.io

import org.trigrid.geometry.IntList
import org.trigrid.mesh.TriMesh
import org.trigrid.mesh.TriMeshFactory

/** What was read of a mesh file, whatever its version, until it is made a [TriMesh]. */
internal class MshContents(private val scanner: MshScanner) {
    /** Names of physical groups by dimension and id. */
    private val names = HashMap<Long, String>()
    private var nodeIds = IntArray(0)
    private var xy = DoubleArray(0)
    private var nodeCount = 0
    private val lines = IntList()
    private val lineGroups = IntList()
    private val triangles = IntList()
    private var surfaceGroup = 0

    /** Nodes in the order of the file, by their id. */
    private lateinit var index: NodeIndex

    fun putName(dimension: Int, id: Int, name: String) {
        names[key(dimension, id)] = name
    }

    fun expectNodes(count: Int) {
        nodeIds = IntArray(count)
        xy = DoubleArray(2 * count)
    }

    /** Reserves the next node for [id]. */
    fun addNode(id: Int): Int {
        if (nodeCount == nodeIds.size) scanner.fail("more nodes than the $nodeCount that were announced")
        nodeIds[nodeCount] = id
        return nodeCount++
    }

    fun place(node: Int, x: Double, y: Double, z: Double) {
        if (z != 0.0) scanner.fail("the node has z = $z: only meshes in the plane z = 0 can be read")
        xy[2 * node] = x
        xy[2 * node + 1] = y
    }

    fun closeNodes() {
        if (nodeCount < nodeIds.size) scanner.fail("${nodeIds.size} nodes were announced, $nodeCount were found")
        index = NodeIndex(nodeIds)
        val twice = index.duplicate
        if (twice >= 0) scanner.fail("the node id $twice is given twice")
    }

    /** Reads the nodes of an element of Gmsh's [type] in the physical group [group], 0 for none. */
    fun readElement(type: Int, group: Int) {
        when (type) {
            LINE -> {
                repeat(2) { lines.add(readNode()) }
                lineGroups.add(group)
            }
            TRIANGLE -> {
                repeat(3) { triangles.add(readNode()) }
                if (surfaceGroup == 0) surfaceGroup = group
            }
            POINT -> readNode()
            else -> scanner.fail("elements of type $type cannot be read, only points (15), lines (1) and triangles (2)")
        }
    }

    private fun readNode(): Int {
        val id = scanner.int("a node id", 1)
        val node = if (::index.isInitialized) index.find(id) else -1
        if (node < 0) scanner.fail("there is no node with the id $id")
        return node
    }

    fun toMesh(): TriMesh {
        if (triangles.size == 0) scanner.fail("the file has no triangles")
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
        val tags = groups.map { nameOf(1, it) }.distinct()
        val tagOfGroup = groups.associateWith { tags.indexOf(nameOf(1, it)) }
        val lineNodes = IntArray(lines.size) { newNumbers[lines[it]] }
        for (node in lineNodes) if (node < 0) scanner.fail("a line has a node that is in no triangle")
        val lineTags = IntArray(lineGroups.size) { tagOfGroup.getValue(lineGroups[it]) }
        val elements = IntArray(triangles.size) { newNumbers[triangles[it]] }
        val regionName = if (surfaceGroup == 0) "domain" else nameOf(2, surfaceGroup)
        try {
            return TriMeshFactory.of(xy.copyOf(2 * used), elements, lineNodes, lineTags, tags, regionName)
        } catch (e: IllegalArgumentException) {
            scanner.fail(e.message ?: "the elements make no mesh")
        }
    }

    private fun nameOf(dimension: Int, group: Int): String = when {
        group == 0 -> TriMeshFactory.UNNAMED
        else -> names[key(dimension, group)] ?: if (dimension == 1) "curve $group" else "surface $group"
    }

    private fun key(dimension: Int, id: Int): Long = (dimension.toLong() shl 32) or id.toLong()

    companion object {
        const val LINE = 1
        const val TRIANGLE = 2
        const val POINT = 15
    }
}

/** Finds nodes by their ids: by a table where ids are dense, else by search in the sorted ids. */
internal class NodeIndex(ids: IntArray) {
    private val table: IntArray?
    private val sorted: LongArray

    /** An id that occurs twice, or -1. */
    val duplicate: Int

    init {
        val highest = ids.maxOrNull() ?: 0
        var twice = -1
        if (highest <= 4L * ids.size + 1000) {
            val nodes = IntArray(highest + 1) { -1 }
            for (node in ids.indices) {
                if (nodes[ids[node]] >= 0) twice = ids[node]
                nodes[ids[node]] = node
            }
            table = nodes
            sorted = LongArray(0)
        } else {
            table = null
            sorted = LongArray(ids.size) { (ids[it].toLong() shl 32) or it.toLong() }
            sorted.sort()
            for (i in 1 until sorted.size) if (sorted[i] ushr 32 == sorted[i - 1] ushr 32) twice = (sorted[i] ushr 32).toInt()
        }
        duplicate = twice
    }

    /** The node with this id, or -1. */
    fun find(id: Int): Int {
        val nodes = table
        if (nodes != null) return if (id < nodes.size) nodes[id] else -1
        val at = sorted.binarySearch(id.toLong() shl 32)
        val place = if (at >= 0) at else -at - 1
        return if (place < sorted.size && sorted[place] ushr 32 == id.toLong()) sorted[place].toInt() else -1
    }
}
