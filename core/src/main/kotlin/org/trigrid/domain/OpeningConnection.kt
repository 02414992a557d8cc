package org.trigrid.domain

/** Openings that stand by themselves, and the shortest free line that joins one to the walk round it. */
internal class OpeningConnection(
    private val xy: DoubleArray,
    /** All that bounds: the path's walks first, then loops that are none of its. */
    private val walks: List<PathWalk>,
    private val pathWalkCount: Int,
) {
    private val nodes = walks.map { it.nodes() }
    private val nesting = LoopNesting(xy, nodes)

    /** Walks of the path that lie in an odd number of others, so that their insides are left out. */
    fun openings(): IntArray = (0 until pathWalkCount).filter { walks[it].isClosed && depth(it) % 2 == 1 }.toIntArray()

    /** The node of the path and the node of the opening between which a connector should run, or null where no line is free. */
    fun lineTo(opening: Int): IntArray? {
        val neighbours = (0 until pathWalkCount).filter { it != opening && isNextTo(it, opening) }
        if (neighbours.isEmpty()) return null
        val from = neighbours.flatMap { nodes[it].asList() }.distinct().sorted().toIntArray()
        val to = nodes[opening].distinct().sorted().toIntArray()
        return FreeLine(xy, segments()).shortest(from, to)
    }

    /** Whether nothing but the domain lies between two walks: one bounds it from outside, both are openings, or so. */
    private fun isNextTo(walk: Int, opening: Int): Boolean {
        val outside = nesting.parentOf(opening)
        return walk == outside || nesting.parentOf(walk) == outside && walks[walk].isClosed
    }

    private fun depth(walk: Int): Int = generateSequence(nesting.parentOf(walk)) { nesting.parentOf(it) }.takeWhile { it >= 0 }.count()

    private fun segments(): IntArray {
        val segments = IntArray(2 * walks.sumOf { it.stepCount })
        var at = 0
        for ((i, walk) in walks.withIndex()) {
            for (step in 0 until walk.stepCount) {
                segments[at++] = nodes[i][step]
                segments[at++] = nodes[i][(step + 1) % nodes[i].size]
            }
        }
        return segments
    }
}
