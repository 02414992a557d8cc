package org.trigrid.editor.document

import org.trigrid.geometry.Point2
import org.trigrid.project.NodeLoop
import org.trigrid.project.Project

/**
 * All nodes of a project under one numbering: the path's by their serial numbers, then the loops' one after the other.
 * Immutable.
 */
internal class DocumentNodes(project: Project) {
    private val xy: DoubleArray

    /** Nodes below this number are the path's. */
    val pathCount: Int = project.path.nodeCount

    /** First node of each loop, and the count of all nodes at the end. */
    private val loopStarts: IntArray

    init {
        val loops: List<NodeLoop> = project.loops
        loopStarts = IntArray(loops.size + 1)
        loopStarts[0] = pathCount
        for ((i, loop) in loops.withIndex()) loopStarts[i + 1] = loopStarts[i] + loop.nodeCount
        xy = project.path.nodeCoordinates().copyOf(2 * loopStarts.last())
        for ((i, loop) in loops.withIndex()) loop.coordinates().copyInto(xy, 2 * loopStarts[i])
    }

    val count: Int get() = xy.size / 2

    fun x(node: Int): Double = xy[2 * node]

    fun y(node: Int): Double = xy[2 * node + 1]

    fun point(node: Int): Point2 = Point2(x(node), y(node))

    /** The loop that [node] belongs to, or -1 where it is the path's. */
    fun loopOf(node: Int): Int {
        if (node < pathCount) return -1
        val found = loopStarts.binarySearch(node)
        var loop = if (found >= 0) found else -found - 2
        while (loopStarts[loop + 1] == loopStarts[loop]) loop++
        return loop
    }

    fun loopStart(loop: Int): Int = loopStarts[loop]

    /** The node at the very place, or -1. */
    fun at(x: Double, y: Double): Int = (0 until count).firstOrNull { x(it) == x && y(it) == y } ?: -1

    /** x and y of the lower left and the upper right corner round all nodes, or null without nodes. */
    fun bounds(): DoubleArray? {
        if (count == 0) return null
        val box = doubleArrayOf(x(0), y(0), x(0), y(0))
        for (node in 1 until count) {
            box[0] = minOf(box[0], x(node))
            box[1] = minOf(box[1], y(node))
            box[2] = maxOf(box[2], x(node))
            box[3] = maxOf(box[3], y(node))
        }
        return box
    }
}
