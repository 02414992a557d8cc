package org.trigrid.domain

import org.trigrid.geometry.Predicates

/** Directions from a node to others, compared exactly by their angle. */
internal class Directions(private val xy: DoubleArray) {
    /**
     * Compares the angles of the directions from [node] to [a] and to [b], each in [0, 360°) from the positive x-axis.
     *
     * @return below 0 if a's angle is smaller, 0 if they are equal, above 0 if a's is larger.
     */
    fun compare(node: Int, a: Int, b: Int): Int {
        val halfA = lowerHalf(node, a)
        val halfB = lowerHalf(node, b)
        if (halfA != halfB) return halfA - halfB
        val turn = orient(node, a, b)
        return if (turn > 0) -1 else if (turn < 0) 1 else 0
    }

    fun orient(a: Int, b: Int, c: Int): Double =
        Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])

    private fun lowerHalf(node: Int, a: Int): Int {
        val up = xy[2 * a + 1] > xy[2 * node + 1]
        val level = xy[2 * a + 1] == xy[2 * node + 1]
        return if (up || (level && xy[2 * a] > xy[2 * node])) 0 else 1
    }
}
