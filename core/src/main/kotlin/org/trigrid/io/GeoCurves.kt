package org.trigrid.io

import org.trigrid.shape.Turn

/** Gmsh's curves. */
internal object GeoCurves {
    /** Null if the points make none. */
    fun of(kind: String, points: List<GeoModel.Point>): PlaneCurve? = when (kind) {
        "Line" -> StraightLine(points[0].x, points[0].y, points[1].x, points[1].y)
        "Circle" -> arc(points[0], points[1], points[2])
        "Ellipse" -> ellipse(points[0], points[1], points[2], points[3])
        "Spline" -> catmullRom(points)
        "BSpline" -> uniformSpline(points)
        else -> bezier(points)
    }

    /** The arc of less than half a turn from [begin] to [end]. */
    private fun ellipse(begin: GeoModel.Point, centre: GeoModel.Point, major: GeoModel.Point, end: GeoModel.Point): PlaneCurve? {
        val length = StrictMath.hypot(major.x - centre.x, major.y - centre.y)
        if (length == 0.0) return null
        val cos = (major.x - centre.x) / length
        val sin = (major.y - centre.y) / length
        // Both ends lie on the ellipse: u^2 / a^2 + v^2 / b^2 = 1 along its axes gives a and b.
        val u0 = square(cos * (begin.x - centre.x) + sin * (begin.y - centre.y))
        val v0 = square(cos * (begin.y - centre.y) - sin * (begin.x - centre.x))
        val u1 = square(cos * (end.x - centre.x) + sin * (end.y - centre.y))
        val v1 = square(cos * (end.y - centre.y) - sin * (end.x - centre.x))
        val determinant = u0 * v1 - u1 * v0
        val a = Math.sqrt(determinant / (v1 - v0))
        val b = Math.sqrt(determinant / (u0 - u1))
        if (!(a > 0 && b > 0 && a < Double.POSITIVE_INFINITY && b < Double.POSITIVE_INFINITY)) return null
        return conic(begin, centre, end, doubleArrayOf(cos * a, sin * a, -sin * b, cos * b))
    }

    private fun square(x: Double) = x * x

    private fun arc(begin: GeoModel.Point, centre: GeoModel.Point, end: GeoModel.Point): PlaneCurve? {
        val radius = StrictMath.hypot(begin.x - centre.x, begin.y - centre.y)
        if (!(radius > 0)) return null
        return conic(begin, centre, end, doubleArrayOf(radius, 0.0, 0.0, radius))
    }

    /** @param axes ax, ay, bx, by. */
    private fun conic(begin: GeoModel.Point, centre: GeoModel.Point, end: GeoModel.Point, axes: DoubleArray): PlaneCurve {
        val from = turns(begin, centre, axes)
        var turns = turns(end, centre, axes) - from
        turns -= Math.rint(turns)
        // A half turn is taken anticlockwise.
        if (turns < -0.5 + HALF_TURN) turns += 1
        return EllipseArc(
            centre.x, centre.y, axes[0], axes[1], axes[2], axes[3], from, from + turns, doubleArrayOf(begin.x, begin.y, end.x, end.y),
        )
    }

    private fun turns(point: GeoModel.Point, centre: GeoModel.Point, axes: DoubleArray): Double {
        val dx = point.x - centre.x
        val dy = point.y - centre.y
        val determinant = axes[0] * axes[3] - axes[1] * axes[2]
        return Turn.of((dx * axes[3] - dy * axes[2]) / determinant, (dy * axes[0] - dx * axes[1]) / determinant)
    }

    /** A Catmull-Rom spline; beyond its ends the points go on straight, or round where it is closed. */
    private fun catmullRom(points: List<GeoModel.Point>): PlaneCurve {
        val n = points.size
        val isClosed = n > 2 && points.first() === points.last()
        fun x(i: Int) = along(i, n, isClosed) { points[it].x }
        fun y(i: Int) = along(i, n, isClosed) { points[it].y }
        // Bezier control points: each point, and a sixth of the way between its neighbours before and behind it.
        val xy = DoubleArray(6 * (n - 1) + 2)
        for (i in 0 until n) {
            val dx = (x(i + 1) - x(i - 1)) / 6
            val dy = (y(i + 1) - y(i - 1)) / 6
            for (k in -1..1) {
                val at = 6 * i + 2 * k
                if (at < 0 || at >= xy.size) continue
                xy[at] = x(i) + k * dx
                xy[at + 1] = y(i) + k * dy
            }
        }
        return pieces(xy, 3)
    }

    private fun along(i: Int, n: Int, isClosed: Boolean, value: (Int) -> Double): Double = when {
        i in 0 until n -> value(i)
        isClosed -> value(if (i < 0) n - 2 else 1)
        i < 0 -> 2 * value(0) - value(1)
        else -> 2 * value(n - 1) - value(n - 2)
    }

    /** Bezier curves of one degree one after the other, as one spline whose inner knots are as many times as its degree. */
    private fun pieces(xy: DoubleArray, degree: Int): SplineCurve {
        val count = xy.size / 2
        val knots = DoubleArray(count + degree + 1) { ((it - 1).coerceAtLeast(0) / degree).coerceAtMost((count - 1) / degree).toDouble() }
        return SplineCurve(degree, knots, xy, DoubleArray(count) { 1.0 })
    }

    private fun bezier(points: List<GeoModel.Point>): PlaneCurve? =
        if (points.size > MOST_BEZIER) null else pieces(coordinates(points), points.size - 1)

    /** Cubic, or of the degree that few points allow, with equal knots: clamped at the ends, or where it is closed going round. */
    private fun uniformSpline(points: List<GeoModel.Point>): PlaneCurve {
        val isClosed = points.size > 3 && points.first() === points.last()
        val ring = points.dropLast(1)
        val control = if (isClosed) List(ring.size + 3) { ring[(it + ring.size - 1) % ring.size] } else points
        val degree = Math.min(3, control.size - 1)
        val spans = control.size - degree
        val knots = DoubleArray(control.size + degree + 1) {
            if (isClosed) it.toDouble() else (it - degree).coerceIn(0, spans).toDouble()
        }
        return SplineCurve(degree, knots, coordinates(control), DoubleArray(control.size) { 1.0 })
    }

    private fun coordinates(points: List<GeoModel.Point>) =
        DoubleArray(2 * points.size) { if (it % 2 == 0) points[it / 2].x else points[it / 2].y }

    private const val MOST_BEZIER = 26

    /** What is nearer to a half turn is one. */
    private const val HALF_TURN = 1e-9
}
