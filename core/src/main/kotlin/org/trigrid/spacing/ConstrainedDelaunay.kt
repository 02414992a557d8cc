package org.trigrid.spacing

import java.util.BitSet
import org.trigrid.diagnostics.Checkpoint
import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.domain.Domain
import org.trigrid.geometry.IntList
import org.trigrid.spacing.DelaunayBuilder.Companion.GHOST
import org.trigrid.spacing.DelaunayBuilder.Companion.NONE

/**
 * Constrained Delaunay triangulation of a domain: its nodes and no others, all its segments, the triangles inside it.
 *
 * Exact in its topology (positive triangles, segments kept, inside told from outside); Delaunay to within rounding.
 * n log n in the expectation, for any order and grading of the nodes.
 */
internal class ConstrainedDelaunay private constructor(
    /** x0, y0, x1, y1, … of the domain's nodes; not modified. */
    val xy: DoubleArray,
    /** 3 per triangle, anticlockwise: half-edge `3t + k` runs from `nodes[3t + k]` to the next. Not modified. */
    val nodes: IntArray,
    /** Per half-edge its twin in the triangle across, or -1 at the boundary. Not modified. */
    val twins: IntArray,
    /** Per node one half-edge that leaves it, or -1 for a node outside of the domain. Not modified. */
    val edgeOfNode: IntArray,
    private val embedded: BitSet,
) {
    val triangleCount: Int get() = nodes.size / 3

    /** Whether the half-edge is a segment of the domain, boundary or embedded. */
    fun isSegment(halfEdge: Int): Boolean = twins[halfEdge] == NONE || embedded.get(halfEdge)

    companion object {
        /**
         * @throws InvalidDomainException where a fault of the domain makes the triangulation impossible; a domain that
         *   has passed the check has none.
         */
        @JvmStatic
        @JvmOverloads
        fun of(domain: Domain, checkpoint: Checkpoint = Checkpoint.unheard()): ConstrainedDelaunay {
            val builder = DelaunayBuilder(domain.xy, checkpoint)
            builder.insertAll()
            recoverSegments(builder, domain, checkpoint)
            return compact(builder, insideTriangles(builder))
        }

        /** Missing segments go in shuffled, by a fixed rule, so that no order of them is a slow one. */
        private fun recoverSegments(builder: DelaunayBuilder, domain: Domain, checkpoint: Checkpoint) {
            val recovery = SegmentRecovery(builder)
            val missing = IntList()
            for (s in 0 until domain.segmentCount) {
                checkpoint.pass()
                if (!recovery.markIfPresent(domain.segmentStart(s), domain.segmentEnd(s), domain.isEmbedded(s))) missing.add(s)
            }
            val order = IntArray(missing.size) { missing[it] }
            order.shuffle(kotlin.random.Random(order.size))
            for (s in order) {
                checkpoint.pass()
                recovery.recover(domain.segmentStart(s), domain.segmentEnd(s), domain.isEmbedded(s))
            }
            recovery.relaxAll()
        }

        private fun insideTriangles(builder: DelaunayBuilder): BooleanArray {
            val inside = BooleanArray(builder.triangleCount)
            val todo = IntList()
            for (e in 0 until 3 * builder.triangleCount) {
                builder.checkpoint.pass()
                if (builder.mark[e] == SegmentRecovery.INSIDE) enter(e / 3, inside, todo)
            }
            while (todo.size > 0) {
                builder.checkpoint.pass()
                val first = 3 * todo.removeLast()
                for (e in first..first + 2) {
                    val mark = builder.mark[e]
                    if (mark == SegmentRecovery.OUTSIDE || builder.origin[e] == GHOST) refuseLeak(builder, first)
                    if (mark != SegmentRecovery.INSIDE) enter(builder.twin[e] / 3, inside, todo)
                }
            }
            return inside
        }

        private fun enter(triangle: Int, inside: BooleanArray, todo: IntList) {
            if (inside[triangle]) return
            inside[triangle] = true
            todo.add(triangle)
        }

        private fun refuseLeak(builder: DelaunayBuilder, first: Int): Nothing {
            val node = if (builder.origin[first] == GHOST) builder.origin[first + 1] else builder.origin[first]
            val x = builder.xy[2 * node]
            val y = builder.xy[2 * node + 1]
            val text = "the segments do not part the inside from the outside near node $node at ($x, $y)"
            throw InvalidDomainException(listOf(Fault(FaultKind.OPEN_WALK, text, x, y, intArrayOf(node))))
        }

        private fun compact(builder: DelaunayBuilder, inside: BooleanArray): ConstrainedDelaunay {
            val newNumber = IntArray(inside.size)
            var count = 0
            for (t in inside.indices) newNumber[t] = if (inside[t]) count++ else NONE
            builder.checkpoint.ask()
            val nodes = IntArray(3 * count)
            val twins = IntArray(3 * count)
            val edgeOfNode = IntArray(builder.nodeCount).apply { fill(NONE) }
            val embedded = BitSet()
            for (old in 0 until 3 * inside.size) {
                builder.checkpoint.pass()
                if (!inside[old / 3]) continue
                val e = 3 * newNumber[old / 3] + old % 3
                val twin = builder.twin[old]
                nodes[e] = builder.origin[old]
                edgeOfNode[nodes[e]] = e
                twins[e] = if (builder.mark[old] == SegmentRecovery.INSIDE) NONE else 3 * newNumber[twin / 3] + twin % 3
                if (builder.mark[old] == SegmentRecovery.EMBEDDED) embedded.set(e)
            }
            return ConstrainedDelaunay(builder.xy, nodes, twins, edgeOfNode, embedded)
        }
    }
}
