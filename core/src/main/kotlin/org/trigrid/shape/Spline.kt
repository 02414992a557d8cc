package org.trigrid.shape

import org.ejml.data.DMatrixRMaj
import org.ejml.data.DMatrixSparseCSC
import org.ejml.data.DMatrixSparseTriplet
import org.ejml.ops.DConvertMatrixStruct
import org.ejml.sparse.FillReducing
import org.ejml.sparse.csc.factory.LinearSolverFactory_DSCC
import org.trigrid.geometry.Point2
import java.util.Arrays

/**
 * A plane cubic spline in the form of its second derivatives at the knots.
 *
 * On the piece between knots i and i + 1, h apart, with a and b the distances of the parameter from the two:
 * P = (M_i b^3 + M_i+1 a^3) / 6h + (P_i / h - M_i h / 6) b + (P_i+1 / h - M_i+1 h / 6) a. That the first derivatives of
 * neighbouring pieces agree is a symmetric positive definite system, tridiagonal or, for a closed curve, cyclic.
 */
internal class Spline private constructor(
    val points: List<Point2>,
    /** Increasing parameters, one per point. */
    val knots: DoubleArray,
    private val momentsX: DoubleArray,
    private val momentsY: DoubleArray,
) {
    fun x(u: Double): Double = value(u, momentsX) { it.x }

    fun y(u: Double): Double = value(u, momentsY) { it.y }

    /** Length per unit of the parameter. */
    fun speed(u: Double): Double = StrictMath.hypot(slope(u, momentsX) { it.x }, slope(u, momentsY) { it.y })

    private inline fun value(u: Double, moments: DoubleArray, coordinate: (Point2) -> Double): Double {
        val i = pieceAt(u)
        val h = knots[i + 1] - knots[i]
        val a = u - knots[i]
        val b = knots[i + 1] - u
        return (moments[i] * b * b * b + moments[i + 1] * a * a * a) / (6 * h) +
            (coordinate(points[i]) / h - moments[i] * h / 6) * b +
            (coordinate(points[i + 1]) / h - moments[i + 1] * h / 6) * a
    }

    private inline fun slope(u: Double, moments: DoubleArray, coordinate: (Point2) -> Double): Double {
        val i = pieceAt(u)
        val h = knots[i + 1] - knots[i]
        val a = u - knots[i]
        val b = knots[i + 1] - u
        return (moments[i + 1] * a * a - moments[i] * b * b) / (2 * h) +
            (coordinate(points[i + 1]) - coordinate(points[i])) / h - (moments[i + 1] - moments[i]) * h / 6
    }

    private fun pieceAt(u: Double): Int {
        val found = Arrays.binarySearch(knots, u)
        val piece = if (found >= 0) found else -found - 2
        return Math.min(Math.max(piece, 0), knots.size - 2)
    }

    companion object {
        fun through(curve: Curve): Spline {
            val closed = curve.ends == CurveEnds.CLOSED
            val points = if (closed) curve.vertices + curve.vertices.first() else curve.vertices
            val knots = DoubleArray(points.size)
            for (i in 1 until points.size) {
                knots[i] = knots[i - 1] + StrictMath.sqrt(points[i - 1].distanceTo(points[i]))
            }
            val system = SplineSystem(knots, closed, curve.ends == CurveEnds.CLAMPED)
            val momentsX = system.moments(
                DoubleArray(points.size) { points[it].x },
                curve.beginTangent?.let { it.x / it.distanceTo(ORIGIN) },
                curve.endTangent?.let { it.x / it.distanceTo(ORIGIN) },
            )
            val momentsY = system.moments(
                DoubleArray(points.size) { points[it].y },
                curve.beginTangent?.let { it.y / it.distanceTo(ORIGIN) },
                curve.endTangent?.let { it.y / it.distanceTo(ORIGIN) },
            )
            return Spline(points, knots, momentsX, momentsY)
        }

        private val ORIGIN = Point2(0.0, 0.0)
    }
}

/** The linear system of a spline's second derivatives; unknown k belongs to knot k + [first]. */
private class SplineSystem(private val knots: DoubleArray, private val closed: Boolean, private val clamped: Boolean) {
    private val pieces = knots.size - 1
    private val first = if (closed || clamped) 0 else 1
    private val size = if (closed) pieces else pieces + 1 - 2 * first
    private val solver = LinearSolverFactory_DSCC.cholesky(FillReducing.NONE)

    init {
        if (size > 0 && !solver.setA(matrix())) Traits.refuse("curve", "vertices are too close together for a spline")
    }

    private fun width(piece: Int): Double = knots[piece + 1] - knots[piece]

    private fun matrix(): DMatrixSparseCSC {
        val entries = DMatrixSparseTriplet(size, size, 3 * size)
        val diagonal = DoubleArray(size)
        for (piece in 0 until pieces) {
            val a = piece - first
            val b = if (closed && piece == pieces - 1) 0 else piece + 1 - first
            val h = width(piece)
            if (a in 0 until size) diagonal[a] += 2 * h
            if (b in 0 until size) diagonal[b] += 2 * h
            if (a in 0 until size && b in 0 until size) {
                entries.addItem(a, b, h)
                entries.addItem(b, a, h)
            }
        }
        for (k in 0 until size) entries.addItem(k, k, diagonal[k])
        return DConvertMatrixStruct.convert(entries, null as DMatrixSparseCSC?)
    }

    /**
     * Second derivatives at all knots for the coordinate [values].
     *
     * @param beginCosine this coordinate of the unit tangent at the first knot; null unless clamped. The tangent is
     *   given the length of the first chord over its parameter step, as the middle of that piece has.
     */
    fun moments(values: DoubleArray, beginCosine: Double?, endCosine: Double?): DoubleArray {
        val moments = DoubleArray(knots.size)
        if (size == 0) return moments
        val right = DMatrixRMaj(size, 1)
        for (piece in 0 until pieces) {
            val slope = (values[piece + 1] - values[piece]) / width(piece)
            val a = piece - first
            val b = if (closed && piece == pieces - 1) 0 else piece + 1 - first
            if (a in 0 until size) right.add(a, 0, 6 * slope)
            if (b in 0 until size) right.add(b, 0, -6 * slope)
        }
        // A centripetal piece has the chord's length = the square of its width, so its mean speed is its width.
        beginCosine?.let { right.add(0, 0, -6 * it * width(0)) }
        endCosine?.let { right.add(size - 1, 0, 6 * it * width(pieces - 1)) }
        val solution = DMatrixRMaj(size, 1)
        solver.solve(right, solution)
        for (k in 0 until size) moments[k + first] = solution.get(k, 0)
        if (closed) moments[pieces] = moments[0]
        return moments
    }
}

/** A spline measured by arc length. */
internal class SplineTrack(private val spline: Spline) : Track {
    private val arcLength = ArcLength(spline::speed, spline.knots)

    override val length: Double get() = arcLength.length

    override fun place(fraction: Double, xy: DoubleArray, index: Int) {
        val end = when (fraction) {
            0.0 -> spline.points.first()
            1.0 -> spline.points.last()
            else -> null
        }
        val u = if (end == null) arcLength.parameterAt(fraction * length) else 0.0
        xy[2 * index] = end?.x ?: spline.x(u)
        xy[2 * index + 1] = end?.y ?: spline.y(u)
    }
}
