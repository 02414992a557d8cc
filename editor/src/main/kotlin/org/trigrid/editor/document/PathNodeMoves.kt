package org.trigrid.editor.document

import org.trigrid.domain.Path
import org.trigrid.geometry.Point2

/** Moves several nodes of a path at once: merging with what lies there, but never with one that is about to leave. */
internal class PathNodeMoves(private var path: Path, nodes: IntArray, places: List<Point2>, pathCount: Int) {
    private class Move(var node: Int, val place: Point2)

    private val waiting = nodes.indices.filter { nodes[it] < pathCount }.mapTo(ArrayList()) { Move(nodes[it], places[it]) }

    fun moved(): Path {
        while (waiting.isNotEmpty()) {
            val next = waiting.firstOrNull { isFree(it) } ?: waiting.first()
            waiting.remove(next)
            move(next)
        }
        return path
    }

    /** Whether no other waiting node still lies where this one goes. */
    private fun isFree(move: Move): Boolean = waiting.none { it !== move && isAt(it.node, move.place) }

    private fun isAt(node: Int, place: Point2): Boolean = path.x(node) == place.x && path.y(node) == place.y

    private fun move(move: Move) {
        if (isAt(move.node, move.place)) return
        val other = (0 until path.nodeCount).firstOrNull { it != move.node && isAt(it, move.place) }
        path = path.moveNode(move.node, move.place.x, move.place.y)
        if (other == null) return
        val removed = maxOf(other, move.node)
        val kept = minOf(other, move.node)
        for (rest in waiting) {
            if (rest.node == removed) rest.node = kept else if (rest.node > removed) rest.node--
        }
    }
}
