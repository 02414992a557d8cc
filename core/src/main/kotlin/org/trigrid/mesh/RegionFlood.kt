package org.trigrid.mesh

import org.trigrid.geometry.IntList

/** Spreads the regions on the sides of tagged edges over the elements, as far as no tagged edge stops them. */
internal class RegionFlood(private val neighbours: IntArray, private val sides: TaggedSides, private val edgeCount: Int) {
    private val isTagged = BooleanArray(neighbours.size)

    init {
        for (edge in 0 until edgeCount) {
            val half = sides.leftOf(edge)
            isTagged[half] = true
            val across = neighbours[half]
            if (across >= 0) isTagged[backFrom(half, across)] = true
        }
    }

    /** Region of each element; -1 where no tagged edge is near. */
    fun regions(left: (Int) -> Int, right: (Int) -> Int): IntArray {
        val regions = IntArray(neighbours.size / 3) { -1 }
        val todo = IntList()
        for (edge in 0 until edgeCount) {
            val half = sides.leftOf(edge)
            enter(half / 3, left(edge), regions, todo)
            if (neighbours[half] >= 0) enter(neighbours[half], right(edge), regions, todo)
        }
        while (todo.size > 0) {
            val element = todo.removeLast()
            for (half in 3 * element..3 * element + 2) {
                if (neighbours[half] >= 0 && !isTagged[half]) enter(neighbours[half], regions[element], regions, todo)
            }
        }
        return regions
    }

    private fun enter(element: Int, region: Int, regions: IntArray, todo: IntList) {
        if (regions[element] >= 0) return
        regions[element] = region
        todo.add(element)
    }

    private fun backFrom(half: Int, across: Int): Int =
        (3 * across..3 * across + 2).first { neighbours[it] == half / 3 }
}
