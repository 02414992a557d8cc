package org.trigrid.mesh

/**
 * The Jacobian determinant of a triangle of six nodes, a quadratic polynomial over the element.
 *
 * The element is a quadratic Bézier triangle, its controls the corners and, for each edge from a to b with the middle m,
 * 2 m - (a + b) / 2. Its two partial derivatives are linear, so that their cross product has the six Bernstein coefficients
 * computed here (Johnen, Remacle, Geuzaine 2013, J. Comput. Phys. 233:359-372).
 *
 * @param places x and y of the six nodes.
 */
internal class QuadraticJacobian(places: DoubleArray) {
    /** Coefficients at the corners. */
    private val corner = DoubleArray(3)

    /** Coefficients of the edges. */
    private val side = DoubleArray(3)

    /** Of the element, in the square of the coordinates' unit. */
    val area: Double get() = (corner.sum() + side.sum()) / COEFFICIENTS / 2

    init {
        val u = DoubleArray(COEFFICIENTS)
        val v = DoubleArray(COEFFICIENTS)
        for (c in 0..1) {
            val p0 = places[c]
            val p1 = places[2 + c]
            val p2 = places[4 + c]
            val q01 = 2 * places[6 + c] - 0.5 * (p0 + p1)
            val q12 = 2 * places[8 + c] - 0.5 * (p1 + p2)
            val q20 = 2 * places[10 + c] - 0.5 * (p2 + p0)
            u[c] = 2 * (q01 - p0)
            u[2 + c] = 2 * (p1 - q01)
            u[4 + c] = 2 * (q12 - q20)
            v[c] = 2 * (q20 - p0)
            v[2 + c] = 2 * (q12 - q01)
            v[4 + c] = 2 * (p2 - q20)
        }
        for (k in 0..2) {
            val next = (k + 1) % 3
            corner[k] = cross(u, v, k, k)
            side[k] = 0.5 * (cross(u, v, k, next) + cross(u, v, next, k))
        }
    }

    private fun cross(u: DoubleArray, v: DoubleArray, i: Int, j: Int) = u[2 * i] * v[2 * j + 1] - u[2 * i + 1] * v[2 * j]

    /** The smallest value on the element: at a corner, or where the derivative along an edge or both of the inside vanish. */
    fun least(): Double {
        var least = minOf(corner[0], minOf(corner[1], corner[2]))
        for (k in 0..2) {
            val a = corner[k]
            val b = side[k]
            val c = corner[(k + 1) % 3]
            val t = (a - b) / (a - 2 * b + c)
            if (t > 0 && t < 1) least = minOf(least, (1 - t) * ((1 - t) * a + 2 * t * b) + t * t * c)
        }
        return minOf(least, leastInside())
    }

    private fun leastInside(): Double {
        val a = corner[0] - 2 * side[0] + corner[1]
        val b = corner[0] - side[0] + side[1] - side[2]
        val c = corner[0] - 2 * side[2] + corner[2]
        val determinant = a * c - b * b
        val u = ((corner[0] - side[0]) * c - (corner[0] - side[2]) * b) / determinant
        val v = ((corner[0] - side[2]) * a - (corner[0] - side[0]) * b) / determinant
        if (!(u > 0 && v > 0 && u + v < 1)) return Double.POSITIVE_INFINITY
        val w = 1 - u - v
        return w * w * corner[0] + u * u * corner[1] + v * v * corner[2] + 2 * (w * u * side[0] + u * v * side[1] + v * w * side[2])
    }

    private companion object {
        const val COEFFICIENTS = 6
    }
}
