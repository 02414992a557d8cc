package org.trigrid.front

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.geometry.Predicates
import org.trigrid.mesh.MutableMesh

/**
 * Makes the initial front of a domain: one edge for a boundary segment, two for an embedded one, linked to loops.
 *
 * Where several loops meet in a node, the edge after `u -> v` is the first to leave `v` when turning clockwise from
 * the way back to `u`: between the two lies nothing but the domain.
 */
internal class FrontBuilder(
    private val domain: Domain,
    mesh: MutableMesh,
    index: FrontIndex,
    private val checkpoint: Checkpoint,
) {
    private val front = Front(mesh, index, 64 + 3 * domain.segmentCount)

    fun build(): Front {
        var embeddedSegments = 0
        for (s in 0 until domain.segmentCount) {
            checkpoint.pass()
            if (!domain.isEmbedded(s)) {
                front.add(domain.segmentStart(s), 0, -1)
            } else {
                front.add(domain.segmentStart(s), 0, -2 - embeddedSegments)
                front.add(domain.segmentEnd(s), 0, -2 - embeddedSegments)
                embeddedSegments++
            }
        }
        linkLoops(ends())
        for (edge in 0 until front.idBound) {
            checkpoint.pass()
            front.place(edge)
        }
        return front
    }

    /** Node where each edge ends. */
    private fun ends(): IntArray {
        val ends = IntArray(front.idBound)
        var edge = 0
        for (s in 0 until domain.segmentCount) {
            checkpoint.pass()
            ends[edge++] = domain.segmentEnd(s)
            if (domain.isEmbedded(s)) ends[edge++] = domain.segmentStart(s)
        }
        return ends
    }

    private fun linkLoops(ends: IntArray) {
        val start = IntArray(domain.nodeCount + 1)
        for (edge in ends.indices) {
            checkpoint.pass()
            start[front.origin[edge] + 1]++
        }
        for (node in 0 until domain.nodeCount) start[node + 1] += start[node]
        val leaving = IntArray(ends.size)
        val at = start.copyOf()
        for (edge in ends.indices) {
            checkpoint.pass()
            leaving[at[front.origin[edge]]++] = edge
        }
        for (edge in ends.indices) {
            checkpoint.pass()
            val node = ends[edge]
            val from = start[node]
            val to = start[node + 1]
            front.linkEdges(edge, if (to - from == 1) leaving[from] else firstClockwise(edge, node, leaving, from, to, ends))
        }
    }

    private fun firstClockwise(edge: Int, node: Int, leaving: IntArray, from: Int, to: Int, ends: IntArray): Int {
        val back = front.origin[edge]
        var best = leaving[from]
        for (i in from + 1 until to) {
            if (comesFirst(node, back, ends[leaving[i]], ends[best])) best = leaving[i]
        }
        return best
    }

    /** Whether, turning clockwise round [node] from [back], [w] is met before [other]. */
    private fun comesFirst(node: Int, back: Int, w: Int, other: Int): Boolean {
        val sectorW = sector(node, back, w)
        val sectorOther = sector(node, back, other)
        return if (sectorW != sectorOther) sectorW < sectorOther else orient(node, w, other) < 0
    }

    /** 0 for a clockwise turn below 180 degrees, 1 for 180, 2 for more, 3 for the full turn. */
    private fun sector(node: Int, back: Int, w: Int): Int {
        val side = orient(node, back, w)
        if (side < 0) return 0
        if (side > 0) return 2
        val dot = (domain.x(back) - domain.x(node)) * (domain.x(w) - domain.x(node)) +
            (domain.y(back) - domain.y(node)) * (domain.y(w) - domain.y(node))
        return if (dot < 0) 1 else 3
    }

    private fun orient(a: Int, b: Int, c: Int): Double =
        Predicates.orient(domain.x(a), domain.y(a), domain.x(b), domain.y(b), domain.x(c), domain.y(c))
}
