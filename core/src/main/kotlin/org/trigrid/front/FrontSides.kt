package org.trigrid.front

import org.trigrid.domain.Domain

/** The sides of a front, kept up to date element by element. */
internal class FrontSides(domain: Domain) {
    private val sides = LinkedHashSet<Long>()

    init {
        for (segment in 0 until domain.segmentCount) {
            val a = domain.segmentStart(segment)
            val b = domain.segmentEnd(segment)
            sides.add(key(a, b))
            if (domain.isEmbedded(segment)) sides.add(key(b, a))
        }
    }

    /** An element over the side from [a] to [b]: each of its sides is the front no more, or its other side now is. */
    fun advance(a: Int, b: Int, c: Int) {
        pass(a, b)
        pass(b, c)
        pass(c, a)
    }

    /** Two nodes a side. */
    fun toArray(): IntArray {
        val nodes = IntArray(2 * sides.size)
        var at = 0
        for (side in sides) {
            nodes[at++] = (side shr 32).toInt()
            nodes[at++] = side.toInt()
        }
        return nodes
    }

    private fun pass(a: Int, b: Int) {
        if (!sides.remove(key(a, b))) sides.add(key(b, a))
    }

    private fun key(a: Int, b: Int): Long = (a.toLong() shl 32) or b.toLong()
}
