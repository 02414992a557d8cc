package org.trigrid.io

import org.trigrid.shape.Turn

/** A piece of a drawing's outline by a parameter. */
internal interface PlaneCurve {
    /** Increasing parameters between which the curve is smooth; it runs from the first to the last. */
    val knots: DoubleArray

    fun x(u: Double): Double

    fun y(u: Double): Double

    /** Length per unit of the parameter. */
    fun speed(u: Double): Double

    val beginX: Double get() = x(knots.first())
    val beginY: Double get() = y(knots.first())
    val endX: Double get() = x(knots.last())
    val endY: Double get() = y(knots.last())
}

/** A curve whose image by an affine map is one of its kind. */
internal interface MappableCurve : PlaneCurve {
    fun mapped(map: AffineMap): MappableCurve
}

/** A straight line. */
internal class StraightLine(
    override val beginX: Double,
    override val beginY: Double,
    override val endX: Double,
    override val endY: Double,
) : MappableCurve {
    override val knots: DoubleArray get() = doubleArrayOf(0.0, 1.0)

    override fun x(u: Double) = beginX + u * (endX - beginX)

    override fun y(u: Double) = beginY + u * (endY - beginY)

    override fun speed(u: Double) = StrictMath.hypot(endX - beginX, endY - beginY)

    override fun mapped(map: AffineMap) =
        StraightLine(map.x(beginX, beginY), map.y(beginX, beginY), map.x(endX, endY), map.y(endX, endY))
}

/**
 * Part of an ellipse: centre + a cos t + b sin t for two conjugate half diameters a and b, t in turns, [from] above or below
 * [to]. An affine map of it is another one.
 */
internal class EllipseArc(
    private val centreX: Double,
    private val centreY: Double,
    private val ax: Double,
    private val ay: Double,
    private val bx: Double,
    private val by: Double,
    private val from: Double,
    private val to: Double,
    private val ends: DoubleArray? = null,
) : MappableCurve {
    override val knots: DoubleArray = DoubleArray(1 + maxOf(1, Math.ceil(4 * Math.abs(to - from)).toInt().coerceAtMost(8))).also {
        for (i in it.indices) it[i] = i.toDouble() / (it.size - 1)
    }

    /** How much of the whole ellipse it is. */
    val share: Double get() = Math.abs(to - from)

    private fun turns(u: Double) = from + u * (to - from)

    override fun x(u: Double): Double = centreX + ax * Turn.cos(turns(u)) + bx * Turn.sin(turns(u))

    override fun y(u: Double): Double = centreY + ay * Turn.cos(turns(u)) + by * Turn.sin(turns(u))

    override fun speed(u: Double): Double {
        val cos = Turn.cos(turns(u))
        val sin = Turn.sin(turns(u))
        return 2 * Math.PI * Math.abs(to - from) * StrictMath.hypot(bx * cos - ax * sin, by * cos - ay * sin)
    }

    override fun mapped(map: AffineMap) = EllipseArc(
        map.x(centreX, centreY), map.y(centreX, centreY), map.a * ax + map.c * ay, map.b * ax + map.d * ay,
        map.a * bx + map.c * by, map.b * bx + map.d * by, from, to,
        ends?.let { doubleArrayOf(map.x(it[0], it[1]), map.y(it[0], it[1]), map.x(it[2], it[3]), map.y(it[2], it[3])) },
    )

    override val beginX: Double get() = ends?.get(0) ?: super<MappableCurve>.beginX
    override val beginY: Double get() = ends?.get(1) ?: super<MappableCurve>.beginY
    override val endX: Double get() = ends?.get(2) ?: super<MappableCurve>.endX
    override val endY: Double get() = ends?.get(3) ?: super<MappableCurve>.endY

    companion object {
        fun circle(x: Double, y: Double, radius: Double, from: Double, to: Double): EllipseArc =
            EllipseArc(x, y, radius, 0.0, 0.0, radius, from, to)

        /** The arc between two given points whose angle is 4 atan([bulge]), above 0 anticlockwise; a line for 0. */
        fun ofBulge(x0: Double, y0: Double, x1: Double, y1: Double, bulge: Double): MappableCurve {
            if (bulge == 0.0) return StraightLine(x0, y0, x1, y1)
            // The centre lies on the bisector, (1 - b^2) / (4 b) of the chord to its left.
            val offset = (1 - bulge * bulge) / (4 * bulge)
            val cx = (x0 + x1) / 2 - offset * (y1 - y0)
            val cy = (y0 + y1) / 2 + offset * (x1 - x0)
            val from = Turn.of(x0 - cx, y0 - cy)
            val radius = StrictMath.hypot(x0 - cx, y0 - cy)
            val turns = 4 * StrictMath.atan(bulge) / (2 * Math.PI)
            return EllipseArc(cx, cy, radius, 0.0, 0.0, radius, from, from + turns, doubleArrayOf(x0, y0, x1, y1))
        }
    }
}

/** A cubic Bezier curve, of control points x0, y0, …, x3, y3. */
internal class BezierCurve(private val c: DoubleArray) : PlaneCurve {
    override val knots: DoubleArray get() = doubleArrayOf(0.0, 1.0)

    override fun x(u: Double): Double = at(u, 0)

    override fun y(u: Double): Double = at(u, 1)

    override fun speed(u: Double): Double = StrictMath.hypot(derivative(u, 0), derivative(u, 1))

    private fun at(u: Double, axis: Int): Double {
        val v = 1 - u
        return v * v * v * c[axis] + 3 * u * v * v * c[2 + axis] + 3 * u * u * v * c[4 + axis] + u * u * u * c[6 + axis]
    }

    private fun derivative(u: Double, axis: Int): Double {
        val v = 1 - u
        return 3 * (v * v * (c[2 + axis] - c[axis]) + 2 * u * v * (c[4 + axis] - c[2 + axis]) + u * u * (c[6 + axis] - c[4 + axis]))
    }

    override val beginX: Double get() = c[0]
    override val beginY: Double get() = c[1]
    override val endX: Double get() = c[6]
    override val endY: Double get() = c[7]

    companion object {
        /** The same curve as one of degree two. */
        fun quadratic(x0: Double, y0: Double, x1: Double, y1: Double, x2: Double, y2: Double) = BezierCurve(
            doubleArrayOf(x0, y0, x0 + 2 * (x1 - x0) / 3, y0 + 2 * (y1 - y0) / 3, x2 + 2 * (x1 - x2) / 3, y2 + 2 * (y1 - y2) / 3, x2, y2),
        )
    }
}

/**
 * A B-spline, rational where weights differ, by de Boor's recurrence (Piegl and Tiller 1997, The NURBS Book, algorithms A2.2, A4.2).
 *
 * @param allKnots not decreasing, degree + 1 more than control points.
 * @param points x0, y0, …; @param weights one for each point.
 */
internal class SplineCurve(
    private val degree: Int,
    private val allKnots: DoubleArray,
    private val points: DoubleArray,
    private val weights: DoubleArray,
) : MappableCurve {
    private val count = weights.size

    /** w x, w y, w. */
    private val control = DoubleArray(3 * count) {
        val w = weights[it / 3]
        if (it % 3 == 2) w else w * points[2 * (it / 3) + it % 3]
    }
    private val d = DoubleArray(3 * (degree + 1))
    private val point = DoubleArray(3)
    private val tangent = DoubleArray(3)

    override val knots: DoubleArray = differentKnots()

    private fun differentKnots(): DoubleArray {
        val knots = DoubleArray(count - degree + 1)
        var found = 0
        for (i in degree..count) if (found == 0 || allKnots[i] > knots[found - 1]) knots[found++] = allKnots[i]
        return knots.copyOf(found)
    }

    override fun x(u: Double): Double {
        evaluate(u)
        return point[0] / point[2]
    }

    override fun y(u: Double): Double {
        evaluate(u)
        return point[1] / point[2]
    }

    override fun speed(u: Double): Double {
        evaluate(u)
        val w = point[2]
        val dx = (tangent[0] - tangent[2] * point[0] / w) / w
        val dy = (tangent[1] - tangent[2] * point[1] / w) / w
        return StrictMath.hypot(dx, dy)
    }

    override fun mapped(map: AffineMap) = SplineCurve(
        degree, allKnots,
        DoubleArray(points.size) {
            val i = it and 1.inv()
            if (it == i) map.x(points[i], points[i + 1]) else map.y(points[i], points[i + 1])
        },
        weights,
    )

    private fun span(u: Double): Int {
        var low = degree
        var high = count
        while (high - low > 1) {
            val middle = (low + high) ushr 1
            if (allKnots[middle] <= u) low = middle else high = middle
        }
        return low
    }

    /** Blends control points pairwise; the difference of the last two gives the derivative. */
    private fun evaluate(u: Double) {
        val span = span(u)
        control.copyInto(d, 0, 3 * (span - degree), 3 * (span + 1))
        for (round in 1..degree) {
            if (round == degree) {
                val width = allKnots[span + 1] - allKnots[span]
                for (k in 0..2) tangent[k] = if (width > 0) degree * (d[3 * degree + k] - d[3 * (degree - 1) + k]) / width else 0.0
            }
            for (j in degree downTo round) {
                val i = span - degree + j
                val width = allKnots[i + degree - round + 1] - allKnots[i]
                val share = if (width > 0) (u - allKnots[i]) / width else 0.0
                for (k in 0..2) d[3 * j + k] = (1 - share) * d[3 * (j - 1) + k] + share * d[3 * j + k]
            }
        }
        for (k in 0..2) point[k] = d[3 * degree + k]
    }
}
