package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.Pose

/**
 * The loops of a domain as a line sweeping over it in a direction meets them: each from the node met first, in the order
 * of these nodes; then the embedded segments by their first ends. Nodes are numbered as they come, those of no segment last.
 */
internal class SweepOrder(
    private val domain: Domain,
    private val pose: Pose,
    private val directionX: Double,
    private val directionY: Double,
    private val checkpoint: Checkpoint,
) {
    /** Per new node its number in the domain. */
    val givenNodes = IntArray(domain.nodeCount)

    /** As in [Domain]. */
    val segments = IntArray(2 * domain.segmentCount)

    /** Per segment its number in the domain. */
    val givenSegments = IntArray(domain.segmentCount)

    /** As in [Domain]. */
    val segmentTags = IntArray(domain.segmentCount)

    /** As in [Domain]. */
    val embedded = BooleanArray(domain.segmentCount) { it >= domain.boundaryCount }
    private val newNodes = IntArray(domain.nodeCount).apply { fill(-1) }
    private val metAt = DoubleArray(domain.nodeCount) { node ->
        checkpoint.pass()
        // Halves, as sums of finite coordinates may be beyond the range of doubles.
        directionX * (pose.x(domain.x(node), domain.y(node)) / 2) + directionY * (pose.y(domain.x(node), domain.y(node)) / 2)
    }
    private var nodes = 0
    private var filled = 0

    init {
        val firsts = IntArray(domain.loopCount) { firstMet(it) }
        val loops = (0 until domain.loopCount).sortedWith(
            compareBy({ metAt[domain.segmentStart(firsts[it])] }, { metAt[domain.segmentEnd(firsts[it])] }),
        )
        for (loop in loops) addLoop(loop, firsts[loop])
        val lines = (domain.boundaryCount until domain.segmentCount).sortedWith(
            compareBy({ metAt[earlierEnd(it)] }, { metAt[laterEnd(it)] }),
        )
        for (line in lines) addSegment(line, earlierEnd(line), laterEnd(line))
        for (node in newNodes.indices.filter { newNodes[it] < 0 }.sortedBy { metAt[it] }) number(node)
    }

    /** What lies beside the segments. */
    fun regions(): DomainRegions = domain.regionMap.laid(givenSegments) { s ->
        val isTurned = givenNodes[segments[2 * s]] != domain.segmentStart(givenSegments[s])
        embedded[s] && isTurned != pose.isMirrored
    }

    /** x0, y0, x1, y1, … of the nodes as they are laid. */
    fun xy(): DoubleArray = DoubleArray(2 * givenNodes.size) {
        checkpoint.pass()
        val node = givenNodes[it / 2]
        // The zero added makes one of the two zeros, which turns would leave apart.
        0.0 + if (it % 2 == 0) pose.x(domain.x(node), domain.y(node)) else pose.y(domain.x(node), domain.y(node))
    }

    /** The segment of a loop whose start is met first. */
    private fun firstMet(loop: Int): Int {
        var first = domain.loopStart(loop)
        for (s in first until domain.loopStart(loop + 1)) {
            checkpoint.pass()
            if (metAt[domain.segmentStart(s)] < metAt[domain.segmentStart(first)]) first = s
        }
        return first
    }

    private fun addLoop(loop: Int, first: Int) {
        val from = domain.loopStart(loop)
        val count = domain.loopStart(loop + 1) - from
        for (i in 0 until count) {
            if (!pose.isMirrored) {
                val s = from + (first - from + i) % count
                addSegment(s, domain.segmentStart(s), domain.segmentEnd(s))
            } else {
                // The way back along the loop: the domain is to be on the left.
                val s = from + Math.floorMod(first - from - 1 - i, count)
                addSegment(s, domain.segmentEnd(s), domain.segmentStart(s))
            }
        }
    }

    private fun earlierEnd(segment: Int): Int {
        val a = domain.segmentStart(segment)
        val b = domain.segmentEnd(segment)
        return if (metAt[b] < metAt[a]) b else a
    }

    private fun laterEnd(segment: Int): Int =
        domain.segmentStart(segment) + domain.segmentEnd(segment) - earlierEnd(segment)

    private fun addSegment(given: Int, start: Int, end: Int) {
        checkpoint.pass()
        segments[2 * filled] = number(start)
        segments[2 * filled + 1] = number(end)
        givenSegments[filled] = given
        segmentTags[filled++] = domain.segmentTag(given)
    }

    private fun number(node: Int): Int {
        if (newNodes[node] < 0) {
            givenNodes[nodes] = node
            newNodes[node] = nodes++
        }
        return newNodes[node]
    }
}
