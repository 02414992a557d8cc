package org.trigrid.domain

import org.trigrid.geometry.IntList

/** Directed segments on their way to a [Domain]: ordered into loops, turned, joined by embedded ones, nodes renumbered. */
internal class SegmentAssembly(
    /** Not modified. */
    private val xy: DoubleArray,
    segments: IntArray,
    tags: IntArray,
    /** Per segment: the one that follows it in the input, or -1. */
    next: IntArray,
    /** Per segment: whether to leave it out. */
    dropped: BooleanArray,
) {
    private var boundary: IntArray
    private var boundaryTags: IntArray
    private val embedded = IntList()
    private val embeddedTags = IntList()

    init {
        val kept = (0 until tags.size).filter { !dropped[it] }.toIntArray()
        val newNumber = IntArray(tags.size).also { it.fill(-1) }
        for ((i, s) in kept.withIndex()) newNumber[s] = i
        val keptSegments = IntArray(2 * kept.size) { segments[2 * kept[it / 2] + it % 2] }
        val keptNext = IntArray(kept.size) { if (next[kept[it]] < 0) -1 else newNumber[next[kept[it]]] }
        val order = LoopOrder(xy, keptSegments, keptNext).order()
        boundary = IntArray(2 * order.size) { keptSegments[2 * order[it / 2] + it % 2] }
        boundaryTags = IntArray(order.size) { tags[kept[order[it]]] }
    }

    /** Reverses every loop if the total area is negative. */
    fun orientByArea() {
        if (SignedArea.sign(xy, boundary, 0, boundaryTags.size) >= 0) return
        val starts = DomainLoops(boundary, boundaryTags.size).starts
        val reversed = IntArray(boundary.size)
        val reversedTags = IntArray(boundaryTags.size)
        for (loop in 0 until starts.size - 1) {
            val from = starts[loop]
            val to = starts[loop + 1]
            for (s in from until to) {
                val source = from + to - 1 - s
                reversed[2 * s] = boundary[2 * source + 1]
                reversed[2 * s + 1] = boundary[2 * source]
                reversedTags[s] = boundaryTags[source]
            }
        }
        boundary = reversed
        boundaryTags = reversedTags
    }

    fun embed(from: Int, to: Int, tag: Int) {
        embedded.add(from)
        embedded.add(to)
        embeddedTags.add(tag)
    }

    fun toDomain(tags: List<String>, regionName: String): Domain =
        toDomain(tags, DomainPoints.NONE, { it }) { DomainRegions.single(Region.of(regionName)) }

    /**
     * Nodes of no segment that are [points] come last.
     *
     * @param tagsOf makes the segments' tags of what was given in their place, in the domain's order; [regions] the regions.
     */
    fun toDomain(
        tags: List<String>, points: DomainPoints, tagsOf: (IntArray) -> IntArray, regions: (IntArray) -> DomainRegions,
    ): Domain {
        val all = boundary + embedded.toArray()
        val newNumber = IntArray(xy.size / 2).also { it.fill(UNUSED) }
        for (node in all) newNumber[node] = ON_SEGMENT
        for (node in points.nodes) if (newNumber[node] == UNUSED) newNumber[node] = LONE
        var count = 0
        for (kind in intArrayOf(ON_SEGMENT, LONE)) {
            for (node in newNumber.indices) if (newNumber[node] == kind) newNumber[node] = count++
        }
        val coordinates = DoubleArray(2 * count)
        for (node in newNumber.indices) {
            if (newNumber[node] >= 0) xy.copyInto(coordinates, 2 * newNumber[node], 2 * node, 2 * node + 2)
        }
        for (i in all.indices) all[i] = newNumber[all[i]]
        val isEmbedded = BooleanArray(all.size / 2) { it >= boundaryTags.size }
        val given = boundaryTags + embeddedTags.toArray()
        val kept = DomainPoints(IntArray(points.nodes.size) { newNumber[points.nodes[it]] }, points.tags)
        return Domain(coordinates, all, tagsOf(given), isEmbedded, tags, regions(given), kept)
    }

    private companion object {
        const val UNUSED = -1
        const val ON_SEGMENT = -2
        const val LONE = -3
    }
}
