package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint

/**
 * A domain made ready for checking: segments joined by place instead of by node number, those that cannot be tested
 * (not finite, or no length) set aside.
 */
internal class CheckedDomain(val domain: Domain, val checkpoint: Checkpoint = Checkpoint.unheard()) {
    val xy: DoubleArray = domain.xy

    /** Per node: the lowest node at the same place; itself where a coordinate is not a number. */
    val place: IntArray = places()

    /** Segments of the domain that can be tested: finite, of some length. Ascending, so boundary first. */
    val tested: IntArray = (0 until domain.segmentCount).filter { isTestable(it) }.toIntArray()

    /** 2 per tested segment: places of its start and end. */
    val ends: IntArray = IntArray(2 * tested.size) { checkpoint.pass(); place[domain.segments[2 * tested[it / 2] + it % 2]] }

    /** The tested segments up to here bound the domain, the others are embedded. */
    val boundaryCount: Int = tested.count { checkpoint.pass(); !domain.isEmbedded(it) }

    /** Tested boundary segments that start, and that end, in each place. */
    val leaving: NodeSegments = NodeSegments.leaving(domain.nodeCount, ends.copyOf(2 * boundaryCount))

    init {
        checkpoint.ask()
    }

    val arriving: NodeSegments = NodeSegments.arriving(domain.nodeCount, ends.copyOf(2 * boundaryCount))

    init {
        checkpoint.ask()
    }

    val tree: SegmentTree = SegmentTree(xy, ends, checkpoint)
    val directions: Directions = Directions(xy)

    fun start(t: Int): Int = ends[2 * t]

    fun end(t: Int): Int = ends[2 * t + 1]

    fun isEmbedded(t: Int): Boolean = t >= boundaryCount

    /** Whether both coordinates are numbers that can be computed with. */
    fun isFinite(node: Int): Boolean = Math.abs(xy[2 * node]) <= LARGEST && Math.abs(xy[2 * node + 1]) <= LARGEST

    /** Whether the segment has no length, or one that cannot be computed with. */
    fun isWithoutLength(s: Int): Boolean {
        val a = domain.segmentStart(s)
        val b = domain.segmentEnd(s)
        return place[a] == place[b] ||
            Math.abs(xy[2 * a] - xy[2 * b]) < SHORTEST && Math.abs(xy[2 * a + 1] - xy[2 * b + 1]) < SHORTEST
    }

    fun isOnBoundary(place: Int): Boolean = leaving.countAt(place) + arriving.countAt(place) > 0

    /** "12 at (1.0, 2.5)". */
    fun nodeText(node: Int): String = "$node at (${xy[2 * node]}, ${xy[2 * node + 1]})"

    /** "3-4", by the node numbers of the domain. */
    fun segmentText(t: Int): String = "${nodeAtStart(t)}-${nodeAtEnd(t)}"

    fun nodeAtStart(t: Int): Int = domain.segmentStart(tested[t])

    fun nodeAtEnd(t: Int): Int = domain.segmentEnd(tested[t])

    private fun isTestable(s: Int): Boolean {
        checkpoint.pass()
        return isFinite(domain.segmentStart(s)) && isFinite(domain.segmentEnd(s)) && !isWithoutLength(s)
    }

    private fun places(): IntArray {
        val index = PlaceIndex(domain.nodeCount)
        val first = IntArray(domain.nodeCount)
        return IntArray(domain.nodeCount) { node ->
            checkpoint.pass()
            val before = index.count
            val number = index.numberOf(xy[2 * node], xy[2 * node + 1])
            if (number == before) first[number] = node
            first[number]
        }
    }

    private companion object {
        /** Products of four coordinates stay in the range of doubles, and so do their squares' reciprocals. */
        const val LARGEST = 1e60
        const val SHORTEST = 1e-60
    }
}
