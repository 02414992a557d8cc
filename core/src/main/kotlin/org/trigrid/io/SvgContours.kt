package org.trigrid.io

import org.trigrid.shape.Turn

/** A subpath. */
internal class SvgContour(val pieces: List<OutlinePiece>, val isClosed: Boolean)

/** Collects the subpaths of one element, mapped into the drawing's coordinates. */
internal class SvgContours(private val map: AffineMap, private val tag: String) {
    private val contours = ArrayList<SvgContour>()
    private var pieces = ArrayList<OutlinePiece>()

    /** All subpaths; one that ends where it began is closed. */
    fun finished(): List<SvgContour> {
        begin(0.0, 0.0)
        return contours
    }

    /** Ends the subpath before. */
    fun begin(x: Double, y: Double) {
        if (pieces.isNotEmpty()) {
            val first = pieces.first().curve
            val last = pieces.last().curve
            finish(first.beginX == last.endX && first.beginY == last.endY)
        }
    }

    fun close(x: Double, y: Double, startX: Double, startY: Double) {
        line(x, y, startX, startY)
        if (pieces.isNotEmpty()) finish(true)
    }

    private fun finish(isClosed: Boolean) {
        contours.add(SvgContour(pieces, isClosed))
        pieces = ArrayList()
    }

    private fun add(curve: PlaneCurve) {
        pieces.add(OutlinePiece(curve, tag))
    }

    fun line(x0: Double, y0: Double, x1: Double, y1: Double) {
        if (x0 == x1 && y0 == y1) return
        add(StraightLine(map.x(x0, y0), map.y(x0, y0), map.x(x1, y1), map.y(x1, y1)))
    }

    /** @param c four control points. */
    fun cubic(c: DoubleArray) {
        add(BezierCurve(DoubleArray(8) { if (it % 2 == 0) map.x(c[it], c[it + 1]) else map.y(c[it - 1], c[it]) }))
    }

    fun quadratic(x0: Double, y0: Double, x1: Double, y1: Double, x2: Double, y2: Double) {
        add(BezierCurve.quadratic(map.x(x0, y0), map.y(x0, y0), map.x(x1, y1), map.y(x1, y1), map.x(x2, y2), map.y(x2, y2)))
    }

    /** SVG 1.1, appendix F.6.5: from the ends to the centre; radii too small for the ends grow. */
    fun arc(arc: SvgArc, x0: Double, y0: Double, x1: Double, y1: Double) {
        if (x0 == x1 && y0 == y1) return
        var rx = Math.abs(arc.rx)
        var ry = Math.abs(arc.ry)
        if (rx == 0.0 || ry == 0.0) return line(x0, y0, x1, y1)
        val cos = Turn.cos(arc.degrees / 360)
        val sin = Turn.sin(arc.degrees / 360)
        // Half the way from the end to the begin, in units of the radii.
        val px = (cos * (x0 - x1) / 2 + sin * (y0 - y1) / 2)
        val py = (-sin * (x0 - x1) / 2 + cos * (y0 - y1) / 2)
        val reach = StrictMath.hypot(px / rx, py / ry)
        if (reach > 1) {
            rx *= reach
            ry *= reach
        }
        val ux = px / rx
        val uy = py / ry
        val square = ux * ux + uy * uy
        val offset = (if (arc.isLarge == arc.isSweep) -1 else 1) * Math.sqrt(Math.max(0.0, 1 / square - 1))
        val cx = offset * uy
        val cy = -offset * ux
        val from = Turn.of(ux - cx, uy - cy)
        var turns = Turn.of(-ux - cx, -uy - cy) - from
        if (arc.isSweep && turns < 0) turns += 1
        if (!arc.isSweep && turns > 0) turns -= 1
        val centreX = cos * rx * cx - sin * ry * cy + (x0 + x1) / 2
        val centreY = sin * rx * cx + cos * ry * cy + (y0 + y1) / 2
        val axes = doubleArrayOf(cos * rx, sin * rx, -sin * ry, cos * ry)
        addEllipse(centreX, centreY, axes, from, from + turns, doubleArrayOf(x0, y0, x1, y1))
    }

    fun ellipse(x: Double, y: Double, rx: Double, ry: Double) {
        if (!(rx > 0 && ry > 0)) return
        addEllipse(x, y, doubleArrayOf(rx, 0.0, 0.0, ry), 0.0, 1.0, null)
        finish(true)
    }

    private fun addEllipse(x: Double, y: Double, axes: DoubleArray, from: Double, to: Double, ends: DoubleArray?) {
        add(
            EllipseArc(
                map.x(x, y), map.y(x, y), map.a * axes[0] + map.c * axes[1], map.b * axes[0] + map.d * axes[1],
                map.a * axes[2] + map.c * axes[3], map.b * axes[2] + map.d * axes[3], from, to,
                ends?.let { doubleArrayOf(map.x(it[0], it[1]), map.y(it[0], it[1]), map.x(it[2], it[3]), map.y(it[2], it[3])) },
            ),
        )
    }

    /** @param rx, ry radii of the corners; NaN for one like the other. */
    fun rectangle(x: Double, y: Double, width: Double, height: Double, rx: Double, ry: Double) {
        if (!(width > 0 && height > 0)) return
        val a = Math.min(if (rx.isNaN()) (if (ry.isNaN()) 0.0 else ry) else rx, width / 2)
        val b = Math.min(if (ry.isNaN()) (if (rx.isNaN()) 0.0 else rx) else ry, height / 2)
        if (!(a > 0 && b > 0)) return polyline(doubleArrayOf(x, y, x + width, y, x + width, y + height, x, y + height), true)
        val corner = SvgArc(a, b, 0.0, isLarge = false, isSweep = true)
        val right = x + width
        val bottom = y + height
        line(x + a, y, right - a, y)
        arc(corner, right - a, y, right, y + b)
        line(right, y + b, right, bottom - b)
        arc(corner, right, bottom - b, right - a, bottom)
        line(right - a, bottom, x + a, bottom)
        arc(corner, x + a, bottom, x, bottom - b)
        line(x, bottom - b, x, y + b)
        arc(corner, x, y + b, x + a, y)
        finish(true)
    }

    /** @param xy x0, y0, … */
    fun polyline(xy: DoubleArray, isClosed: Boolean) {
        for (i in 1 until xy.size / 2) line(xy[2 * i - 2], xy[2 * i - 1], xy[2 * i], xy[2 * i + 1])
        if (isClosed && xy.size >= 6) close(xy[xy.size - 2], xy[xy.size - 1], xy[0], xy[1])
    }
}
