package org.trigrid.domain

/**
 * The domain of closed walks over shared nodes, as a completed path gives them.
 *
 * A step u→v that is also taken as v→u is a connector: both are dropped, or kept as one embedded segment. What is left
 * falls apart into loops. The walks are then taken so that their total area is positive; the domain lies on the left.
 * A dead end, where a walk runs to a node of no other use and straight back, connects nothing: without [keepConnectors]
 * it stays, and [DomainCheck] reports it as a spike. Nodes that no segment uses any more are left out.
 *
 * @param xy x0, y0, x1, y1, …; not modified.
 * @param walks node numbers; the walk k steps from walks[k][i] to walks[k][(i + 1) % n].
 * @param stepTags per walk and step: index into [tags].
 */
internal fun Domain.Companion.fromWalks(
    xy: DoubleArray,
    walks: List<IntArray>,
    stepTags: List<IntArray>,
    tags: List<String>,
    regionName: String,
    keepConnectors: Boolean,
): Domain {
    val steps = WalkSteps(xy.size / 2, walks, stepTags)
    val connectors = ConnectorSearch(steps, keepConnectors)
    val assembly = SegmentAssembly(xy, steps.segments, steps.tags, steps.next, connectors.dropped)
    assembly.orientByArea()
    for (s in connectors.firstOfPair) assembly.embed(steps.segments[2 * s], steps.segments[2 * s + 1], steps.tags[s])
    return assembly.toDomain(tags, regionName)
}

/** The steps of all walks one after the other. */
internal class WalkSteps(val nodeCount: Int, walks: List<IntArray>, stepTags: List<IntArray>) {
    val count: Int = walks.sumOf { it.size }

    /** 2 per step: from, to. */
    val segments: IntArray = IntArray(2 * count)
    val tags: IntArray = IntArray(count)
    val next: IntArray = IntArray(count)
    val previous: IntArray = IntArray(count)

    init {
        require(walks.size == stepTags.size) { "${walks.size} walks have tags for ${stepTags.size}" }
        var first = 0
        for ((k, walk) in walks.withIndex()) {
            val n = walk.size
            require(stepTags[k].size == n) { "walk $k has $n steps, but ${stepTags[k].size} tags" }
            for (i in 0 until n) {
                segments[2 * (first + i)] = walk[i]
                segments[2 * (first + i) + 1] = walk[(i + 1) % n]
                tags[first + i] = stepTags[k][i]
                next[first + i] = first + (i + 1) % n
                previous[first + i] = first + (i + n - 1) % n
            }
            first += n
        }
    }
}

/** Finds the steps that are taken in both directions. */
internal class ConnectorSearch(private val steps: WalkSteps, private val keepDeadEnds: Boolean) {
    private val leaving = NodeSegments.leaving(steps.nodeCount, steps.segments)
    private val arriving = NodeSegments.arriving(steps.nodeCount, steps.segments)
    private val partner = IntArray(steps.count).also { it.fill(-1) }

    /** Per step: whether it is no boundary. */
    val dropped: BooleanArray

    /** The first-taken step of each connector, ascending. */
    val firstOfPair: IntArray

    init {
        for (s in 0 until steps.count) if (partner[s] < 0) pair(s)
        if (!keepDeadEnds) for (s in 0 until steps.count) if (isDeadEnd(s)) releaseDeadEnd(s)
        dropped = BooleanArray(steps.count) { partner[it] >= 0 }
        firstOfPair = if (keepDeadEnds) firsts() else IntArray(0)
    }

    private fun pair(s: Int) {
        val from = steps.segments[2 * s]
        val to = steps.segments[2 * s + 1]
        if (from == to) return
        var found = -1
        if (leaving.countAt(to) <= arriving.countAt(from)) {
            leaving.forEachAt(to) { if (found < 0 && partner[it] < 0 && steps.segments[2 * it + 1] == from) found = it }
        } else {
            arriving.forEachAt(from) { if (found < 0 && partner[it] < 0 && steps.segments[2 * it] == to) found = it }
        }
        if (found < 0) return
        partner[s] = found
        partner[found] = s
    }

    private fun isDeadEnd(s: Int): Boolean =
        partner[s] >= 0 && partner[s] == steps.next[s] && leaving.countAt(steps.segments[2 * s + 1]) == 1

    /** Takes back the pairing from the tip of a dead end to where something else joins it. */
    private fun releaseDeadEnd(tip: Int) {
        var out = tip
        var back = steps.next[tip]
        while (partner[out] == back) {
            partner[out] = -1
            partner[back] = -1
            if (leaving.countAt(steps.segments[2 * out]) != 2) return
            out = steps.previous[out]
            back = steps.next[back]
        }
    }

    private fun firsts(): IntArray = (0 until steps.count).filter { partner[it] > it }.toIntArray()
}
