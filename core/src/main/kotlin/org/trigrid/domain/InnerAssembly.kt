package org.trigrid.domain

import org.trigrid.geometry.IntList

/** The domain with lines and points embedded in it; its own nodes of segments keep their numbers, those of lines follow. */
internal fun Domain.withLinesAndPoints(lines: List<InnerLine>, points: List<InnerPoint>): Domain {
    if (lines.isEmpty() && points.isEmpty()) return this
    val places = PlaceIndex(nodeCount)
    // Nodes at one place, which are a fault, must keep their numbers: the index knows the first of them only.
    val numberOfPlace = IntList()
    for (node in 0 until nodeCount) if (places.numberOf(x(node), y(node)) == numberOfPlace.size) numberOfPlace.add(node)
    val added = IntList()
    fun nodeAt(x: Double, y: Double): Int {
        val place = places.numberOf(x, y)
        if (place == numberOfPlace.size) {
            numberOfPlace.add(nodeCount + added.size)
            added.add(place)
        }
        return numberOfPlace[place]
    }
    val tagNumbers = LinkedHashMap<String, Int>()
    for (tag in tags) tagNumbers.putIfAbsent(tag, tagNumbers.size)
    val allTags = ArrayList(tags)
    fun tagNumber(tag: String): Int = tagNumbers.getOrPut(tag) { allTags.add(tag); allTags.size - 1 }

    val newSegments = IntList()
    val newTags = IntList()
    for (line in lines) {
        val nodes = IntArray(line.xy.size / 2) { nodeAt(line.xy[2 * it], line.xy[2 * it + 1]) }
        for (i in 0 until if (line.isClosed) nodes.size else nodes.size - 1) {
            newSegments.add(nodes[i])
            newSegments.add(nodes[(i + 1) % nodes.size])
            newTags.add(tagNumber(line.tag))
        }
    }
    val pointNodes = this.points.nodes + IntArray(points.size) { nodeAt(points[it].x, points[it].y) }
    val pointTags = this.points.tags + IntArray(points.size) { tagNumber(points[it].tag) }
    val xy = this.xy + places.toArray().let { all -> DoubleArray(2 * added.size) { all[2 * added[it / 2] + it % 2] } }

    // Nodes of the new lines go before those of no segment.
    val isOnSegment = BooleanArray(xy.size / 2)
    for (node in segments) isOnSegment[node] = true
    for (i in 0 until newSegments.size) isOnSegment[newSegments[i]] = true
    val order = isOnSegment.indices.filter { isOnSegment[it] } + isOnSegment.indices.filter { !isOnSegment[it] }
    val newNumber = IntArray(order.size)
    for ((i, node) in order.withIndex()) newNumber[node] = i
    val allSegments = segments + newSegments.toArray()
    return Domain(
        DoubleArray(xy.size) { xy[2 * order[it / 2] + it % 2] },
        IntArray(allSegments.size) { newNumber[allSegments[it]] },
        segmentTags + newTags.toArray(),
        embedded + BooleanArray(newTags.size) { true },
        allTags,
        regionMap.withLines(segmentCount, newTags.size),
        DomainPoints(IntArray(pointNodes.size) { newNumber[pointNodes[it]] }, pointTags),
    )
}
