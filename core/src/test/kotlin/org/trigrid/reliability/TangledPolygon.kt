package org.trigrid.reliability

import org.trigrid.geometry.Predicates
import java.util.Random

/**
 * A random simple polygon through random points: a random tour, uncrossed pair by pair (2-opt; each step shortens the tour, so
 * it ends). Such polygons have narrow bays, sharp corners and segments that all but touch.
 */
internal object TangledPolygon {
    fun make(r: Random, n: Int): DoubleArray {
        val xy = DoubleArray(2 * n) { r.nextDouble() }
        val tour = IntArray(n) { it }
        do {
            val changed = uncross(xy, tour)
        } while (changed)
        return DoubleArray(2 * n) { xy[2 * tour[it / 2] + it % 2] }
    }

    private fun uncross(xy: DoubleArray, tour: IntArray): Boolean {
        val n = tour.size
        for (i in 0 until n - 2) {
            for (j in i + 2 until n) {
                if (i == 0 && j == n - 1 || !cross(xy, tour[i], tour[i + 1], tour[j], tour[(j + 1) % n])) continue
                tour.reverse(i + 1, j + 1)
                return true
            }
        }
        return false
    }

    private fun cross(xy: DoubleArray, a: Int, b: Int, c: Int, d: Int): Boolean =
        side(xy, a, b, c) * side(xy, a, b, d) < 0 && side(xy, c, d, a) * side(xy, c, d, b) < 0

    private fun side(xy: DoubleArray, a: Int, b: Int, c: Int) = Math.signum(
        Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]),
    )
}
