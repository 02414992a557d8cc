package org.trigrid.domain

/**
 * A walk under construction: legs[i] leads from nodes[i] to nodes[i + 1]. A closed walk has its first node again as last.
 *
 * @param group number of the loop that it is, or came off.
 */
internal class PathTrace(var group: Int) {
    val nodes: ArrayList<PathNode> = ArrayList()
    val legs: ArrayList<PathLeg> = ArrayList()

    val isClosed: Boolean get() = nodes.size > 1 && nodes.first() === nodes.last()

    /** Goes on to [node], unless it is there already. */
    fun go(node: PathNode, leg: PathLeg) {
        if (nodes.last() === node) return
        nodes.add(node)
        legs.add(leg)
    }

    /** How often the walk passes [node]. */
    fun count(node: PathNode): Int = nodes.count { it === node } - if (isClosed && nodes.first() === node) 1 else 0

    /** Adds the shapes whose legs end at [node] to [shapes]. */
    fun shapesAt(node: PathNode, shapes: MutableSet<Int>) {
        for ((i, leg) in legs.withIndex()) {
            if (leg.shape >= 0 && (nodes[i] === node || nodes[i + 1] === node)) shapes.add(leg.shape)
        }
    }

    fun replace(removed: PathNode, kept: PathNode) = rebuild { if (it === removed) kept else it }

    /** Takes [node] out; its neighbours are joined by a leg of the shape that led to it. */
    fun remove(node: PathNode) = rebuild { if (it === node) null else it }

    /** Passes every node through [map]; null leaves it out, and legs that shrink to a node are left out. */
    private fun rebuild(map: (PathNode) -> PathNode?) {
        val closed = isClosed
        val oldNodes = ArrayList(nodes)
        val oldLegs = ArrayList(legs)
        nodes.clear()
        legs.clear()
        val count = if (closed) oldNodes.size - 1 else oldNodes.size
        var leaving: PathLeg? = null
        for (i in 0 until count) {
            val node = map(oldNodes[i]) ?: continue
            if (nodes.isEmpty()) nodes.add(node) else go(node, leaving!!)
            leaving = oldLegs.getOrNull(i)
        }
        if (closed && nodes.size > 1) go(nodes.first(), leaving!!)
    }

    /** Puts [node] between [from] and [to], both ways, and adds the shapes of the legs concerned to [shapes]. */
    fun insert(from: PathNode, to: PathNode, node: PathNode, shapes: MutableSet<Int>) {
        for (i in legs.indices.reversed()) {
            val there = nodes[i] === from && nodes[i + 1] === to
            val back = nodes[i] === to && nodes[i + 1] === from
            if (!there && !back) continue
            nodes.add(i + 1, node)
            legs.add(i, legs[i])
            shapes.add(legs[i].shape)
        }
    }

    /** The same closed walk begun at [node], one of its nodes, and travelled backwards if asked to. */
    fun begunAt(node: PathNode, isTurned: Boolean): PathTrace {
        val count = legs.size
        val begin = nodes.indexOf(node)
        val walk = PathTrace(group)
        for (i in 0..count) walk.nodes.add(nodes[(begin + i) % count])
        for (i in 0 until count) walk.legs.add(legs[(begin + i) % count])
        if (isTurned) walk.turn()
        return walk
    }

    /** Travels the walk the other way round. */
    fun turn() {
        nodes.reverse()
        legs.reverse()
    }

    /** Goes, where it first passes the first node of [way], along that, round [loop], which begins at its end, and back. */
    fun detour(way: List<PathNode>, leg: PathLeg, loop: PathTrace) {
        val at = nodes.indexOf(way.first())
        val along = List(way.size - 1) { leg }
        nodes.addAll(at + 1, way.drop(1) + loop.nodes.drop(1) + way.reversed().drop(1))
        legs.addAll(at, along + loop.legs + along)
    }

    /**
     * Splits the walk where it passes [node] a second time: the part between comes off as a closed walk of its own.
     *
     * @return the part that came off; null where either part would be no loop, or a connector joins them.
     */
    fun splitAt(node: PathNode): PathTrace? {
        val places = nodes.indices.filter { nodes[it] === node && !(isClosed && it == nodes.size - 1) }
        if (places.size != 2) return null
        val from = places[0]
        val to = places[1]
        val left = legs.size - (to - from)
        if (to - from < LOOP || left < (if (isClosed) LOOP else 1)) return null
        if (isJoinedByConnector(from, to)) return null
        val part = PathTrace(group)
        part.nodes.addAll(nodes.subList(from, to + 1))
        part.legs.addAll(legs.subList(from, to))
        nodes.subList(from + 1, to + 1).clear()
        legs.subList(from, to).clear()
        return part
    }

    /** Whether a leg of from..to is travelled back outside of it. */
    private fun isJoinedByConnector(from: Int, to: Int): Boolean {
        val inside = HashMap<PathNode, HashSet<PathNode>>()
        for (i in from until to) inside.getOrPut(nodes[i]) { HashSet() }.add(nodes[i + 1])
        for (i in legs.indices) {
            if (i !in from until to && inside[nodes[i + 1]]?.contains(nodes[i]) == true) return true
        }
        return false
    }

    private companion object {
        /** Fewest legs of a loop. */
        const val LOOP = 3
    }
}
