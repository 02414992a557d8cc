package org.trigrid.front

import org.trigrid.mesh.MutableMesh

/**
 * The front: the directed edges between the mesh made so far and the part still to be meshed, which lies on their left.
 *
 * Edges form loops through [next] and [previous]; a loop has no record of its own. The *corner* `c` is the place where
 * edge `c` begins: node [origin]`[c]`, between `previous[c]` and `c`. A node may have several corners. Four
 * operations, each O(1), change the front by one element, and [bridge] alone splits a loop or merges two:
 * ```
 *   ear at the end      ear at the start       bridge, q on the front     new node P
 *    q                          q              ... <--q<-- ...               P
 *    ^\                        /^                 q is any corner           / \
 *    | \ becomes              / | becomes         a-->q and q-->b          /   \
 *    |  \ a-->q              /  | q-->b           replace a-->b           a-----b
 *    b<--a                  b<--a
 * ```
 */
internal class Front(private val mesh: MutableMesh, private val index: FrontIndex, capacity: Int) {
    @JvmField var origin = IntArray(capacity)

    @JvmField var next = IntArray(capacity)

    @JvmField var previous = IntArray(capacity)

    /** Elements between the edge and the original boundary. */
    @JvmField var layer = IntArray(capacity)

    /** How often the edge was refused as it stands. */
    @JvmField var fails = ByteArray(capacity)

    /** Half-edge of the mesh on the other side: -1 outside, `-2 - s` for a side of embedded segment `s`. */
    private var owner = IntArray(capacity)
    private val embeddedHalf = IntArray(mesh.embedded.size) { -1 }
    private var used = 0
    private var free = -1

    /** Edges on the front. */
    @JvmField var edgeCount = 0

    /** Edge ids stay below this. */
    val idBound: Int get() = used

    fun isLive(edge: Int): Boolean = origin[edge] >= 0

    fun destination(edge: Int): Int = origin[next[edge]]

    /** Adds an edge from [a]; the caller links it and then calls [place]. */
    fun add(a: Int, edgeLayer: Int, halfEdge: Int): Int {
        val edge: Int
        if (free >= 0) {
            edge = free
            free = next[edge]
        } else {
            edge = used++
            if (edge == origin.size) grow()
        }
        origin[edge] = a
        layer[edge] = edgeLayer
        fails[edge] = 0
        owner[edge] = halfEdge
        edgeCount++
        return edge
    }

    fun linkEdges(first: Int, second: Int) {
        next[first] = second
        previous[second] = first
    }

    /** Enters [edge] into the index where it now lies. */
    fun place(edge: Int) {
        val a = 2 * origin[edge]
        val b = 2 * origin[next[edge]]
        val xy = mesh.xy
        index.insert(edge, xy[a], xy[a + 1], xy[b], xy[b + 1])
    }

    /** Element over [edge] and the edge after it; [edge] now joins the far ends. Returns the edge that is gone. */
    fun earAtEnd(edge: Int): Int {
        val gone = next[edge]
        val beyond = next[gone]
        val t = mesh.addElement(origin[edge], origin[gone], origin[beyond])
        own(edge, 3 * t)
        own(gone, 3 * t + 1)
        index.remove(edge)
        remove(gone)
        linkEdges(edge, beyond)
        renew(edge, 3 * t + 2)
        return gone
    }

    /** Element over [edge] and the edge before it, which now joins the far ends. Returns the edge that is gone: [edge]. */
    fun earAtStart(edge: Int): Int {
        val kept = previous[edge]
        val beyond = next[edge]
        val t = mesh.addElement(origin[edge], origin[beyond], origin[kept])
        own(edge, 3 * t)
        own(kept, 3 * t + 2)
        index.remove(kept)
        layer[kept] = layer[edge]
        remove(edge)
        linkEdges(kept, beyond)
        renew(kept, 3 * t + 1)
        return edge
    }

    /** Element over [edge] with the node of [corner], no neighbour of it; returns the new edge from that node. */
    fun bridge(edge: Int, corner: Int): Int {
        val beyond = next[edge]
        val before = previous[corner]
        val t = mesh.addElement(origin[edge], origin[beyond], origin[corner])
        own(edge, 3 * t)
        index.remove(edge)
        val fresh = add(origin[corner], layer[edge] + 1, 3 * t + 1)
        linkEdges(edge, corner)
        linkEdges(before, fresh)
        linkEdges(fresh, beyond)
        renew(edge, 3 * t + 2)
        place(fresh)
        return fresh
    }

    /** Element over [edge] with the new node [node]; returns the new edge from it. */
    fun advance(edge: Int, node: Int): Int {
        val beyond = next[edge]
        val t = mesh.addElement(origin[edge], origin[beyond], node)
        own(edge, 3 * t)
        index.remove(edge)
        val fresh = add(node, layer[edge] + 1, 3 * t + 1)
        linkEdges(edge, fresh)
        linkEdges(fresh, beyond)
        renew(edge, 3 * t + 2)
        place(fresh)
        return fresh
    }

    /** If [edge] and the next one run there and back, removes both and joins their elements. Returns the other, or -1. */
    fun closeIfFlat(edge: Int): Int {
        val other = next[edge]
        if (next[other] != edge) return -1
        val mine = owner[edge]
        val theirs = owner[other]
        when {
            mine >= 0 && theirs >= 0 -> mesh.link(mine, theirs)
            mine >= 0 -> settle(theirs, mine)
            theirs >= 0 -> settle(mine, theirs)
        }
        remove(edge)
        remove(other)
        return other
    }

    private fun renew(edge: Int, halfEdge: Int) {
        owner[edge] = halfEdge
        layer[edge]++
        fails[edge] = 0
        place(edge)
    }

    /** The element's [halfEdge] takes the place of [edge] as the neighbour of what lies beyond it. */
    private fun own(edge: Int, halfEdge: Int) = settle(owner[edge], halfEdge)

    private fun settle(beyond: Int, halfEdge: Int) {
        if (beyond >= -1) {
            mesh.link(halfEdge, beyond)
            return
        }
        val segment = -2 - beyond
        if (embeddedHalf[segment] >= 0) mesh.link(halfEdge, embeddedHalf[segment]) else embeddedHalf[segment] = halfEdge
    }

    private fun remove(edge: Int) {
        index.remove(edge)
        origin[edge] = -1
        next[edge] = free
        free = edge
        edgeCount--
    }

    private fun grow() {
        val size = 2 * origin.size
        origin = origin.copyOf(size)
        next = next.copyOf(size)
        previous = previous.copyOf(size)
        layer = layer.copyOf(size)
        fails = fails.copyOf(size)
        owner = owner.copyOf(size)
    }
}
