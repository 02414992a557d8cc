package org.trigrid.domain

/** Moves of several nodes at once, to be appended to a path's history. */
internal class NodeMoves(
    private val history: List<PathStep>,
    private val replay: PathReplay,
    private val nodes: List<NodeKey>,
    private val xy: DoubleArray,
) {
    /** The history with the moves; in place of moves of the same nodes where it ends with such. */
    fun steps(): List<PathStep> {
        val before = history.subList(0, kept())
        val meet = takesPlaces(if (before.size == history.size) replay else PathReplay(before))
        return before + nodes.indices.map { MoveStep(nodes[it], xy[2 * it], xy[2 * it + 1], meet && it < nodes.size - 1) }
    }

    private fun kept(): Int {
        val moved = nodes.toHashSet()
        var end = history.size
        while (end > 0 && end - 1 !in replay.merging && (history[end - 1] as? MoveStep)?.node in moved) end--
        // The first of what is kept must not be taken for one of them.
        return if ((history.getOrNull(end - 1) as? MoveStep)?.isWithNext == true) history.size else end
    }

    /** Whether a node goes where another of them has been, so that the order of the moves would matter. */
    private fun takesPlaces(now: PathReplay): Boolean {
        val places = HashSet<Pair<Double, Double>>()
        for (key in nodes) now.nodeOf(key)?.let { places.add(it.x + 0.0 to it.y + 0.0) }
        return nodes.indices.any { xy[2 * it] + 0.0 to xy[2 * it + 1] + 0.0 in places }
    }
}
