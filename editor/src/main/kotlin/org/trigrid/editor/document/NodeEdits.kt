package org.trigrid.editor.document

import org.trigrid.geometry.Point2
import org.trigrid.project.NodeLoop

/** Changes of single nodes, wherever they are kept. */
internal object NodeEdits {
    /**
     * Moves nodes to new places. One put onto another of the path merges with it: the higher serial number goes.
     *
     * @param places size of [nodes].
     */
    fun move(document: EditorDocument, nodes: IntArray, places: List<Point2>): EditorDocument {
        val moved = moveInLoops(document, nodes, places)
        val onPath = nodes.indices.filter { nodes[it] < document.nodes.pathCount }
        if (onPath.isEmpty()) return moved
        val numbers = IntArray(onPath.size) { nodes[onPath[it]] }
        val xy = DoubleArray(2 * onPath.size) { i -> places[onPath[i / 2]].let { if (i % 2 == 0) it.x else it.y } }
        return moved.withPath(if (numbers.size == 1) moved.path.moveNode(numbers[0], xy[0], xy[1]) else moved.path.moveNodes(numbers, xy))
    }

    fun delete(document: EditorDocument, nodes: Set<Int>): EditorDocument {
        val all = document.nodes
        var path = document.path
        for (node in nodes.filter { it < all.pathCount }.sortedDescending()) path = path.deleteNode(node)
        val loops = document.loops.mapIndexedNotNull { i, loop ->
            val start = all.loopStart(i)
            val kept = (0 until loop.nodeCount).filter { start + it !in nodes }
            if (kept.size == loop.nodeCount) loop else shrunk(kept.map { Point2(loop.x(it), loop.y(it)) }, kept.map { loop.segmentTags[it] })
        }
        return document.with { path(path).loops(loops) }
    }

    /** A node at [point] between the neighbours [from] and [to]. */
    fun insert(document: EditorDocument, from: Int, to: Int, point: Point2): EditorDocument {
        val number = document.nodes.loopOf(from)
        if (number < 0) return document.withPath(document.path.insertNode(from, to, point.x, point.y))
        val loop = document.loops[number]
        val at = from - document.nodes.loopStart(number) + 1
        val points = (0 until loop.nodeCount).mapTo(ArrayList()) { Point2(loop.x(it), loop.y(it)) }
        points.add(at, point)
        val tags = ArrayList(loop.segmentTags)
        tags.add(at, tags[at - 1])
        return document.withLoops(document.loops.replaced(number, loopOf(points, tags)))
    }

    /** The number that [insert] gives to the node between [from] and its next neighbour. */
    fun insertedNumber(from: Int): Int = from + 1

    private fun moveInLoops(document: EditorDocument, nodes: IntArray, places: List<Point2>): EditorDocument {
        val all = document.nodes
        val changed = HashMap<Int, DoubleArray>()
        for ((i, node) in nodes.withIndex()) {
            val number = all.loopOf(node)
            if (number < 0) continue
            val xy = changed.getOrPut(number) { document.loops[number].coordinates() }
            val at = node - all.loopStart(number)
            xy[2 * at] = places[i].x
            xy[2 * at + 1] = places[i].y
        }
        if (changed.isEmpty()) return document
        return document.withLoops(
            document.loops.mapIndexed { i, loop -> changed[i]?.let { NodeLoop(it, loop.segmentTags) } ?: loop },
        )
    }

    /** Null where fewer than three nodes are left, which bound nothing. */
    private fun shrunk(points: List<Point2>, tags: List<String>): NodeLoop? = if (points.size < 3) null else loopOf(points, tags)

    private fun loopOf(points: List<Point2>, tags: List<String>): NodeLoop =
        NodeLoop(DoubleArray(2 * points.size) { if (it % 2 == 0) points[it / 2].x else points[it / 2].y }, tags)
}

/** [list] with another item at [index]. */
internal fun <T> List<T>.replaced(index: Int, item: T): List<T> = mapIndexed { i, old -> if (i == index) item else old }
