package org.trigrid.reliability

import org.trigrid.RandomDomains.Family
import org.trigrid.domain.Domain
import org.trigrid.domain.Path
import org.trigrid.geometry.Point2
import org.trigrid.shape.Arc
import org.trigrid.shape.Circle
import org.trigrid.shape.Direction
import org.trigrid.shape.Distribution
import org.trigrid.shape.Ellipse
import org.trigrid.shape.Line
import org.trigrid.shape.Polygon
import org.trigrid.shape.Rectangle
import org.trigrid.shape.Shape
import java.util.Random

/**
 * Completed domains as the paper makes them: shapes, openings on connectors that are straight, bent, forked or hung on
 * other openings, dead ends, and loops of their own; connectors dropped and kept.
 */
internal object PathDomains {
    val families: List<Family> = listOf(
        Family("connectors dropped", every = 4) { PathMaker(it, false).domain() },
        Family("connectors kept", every = 4) { PathMaker(it, true).domain() },
    )
}

/** A box of columns, one unit wide and four high; from the lower side of each hangs an opening, or nothing. */
private class PathMaker(private val r: Random, private val keep: Boolean) {
    private val columns = 1 + r.nextInt(5)
    private var path = Path.EMPTY

    fun domain(): Domain {
        path = path.append(line(-0.1, 0.0, 0.5, 0.0))
        for (k in 0 until columns) {
            opening(k + 0.5)
            val next = if (k == columns - 1) columns + 0.1 else k + 1.5
            path = path.append(line(k + 0.5, 0.0, next, 0.0))
        }
        path = path.append(line(columns + 0.1, 0.0, columns + 0.1, 4.1))
        path = if (r.nextBoolean()) {
            path.append(line(columns + 0.1, 4.1, -0.1, 4.1))
        } else {
            path.append(styled(Arc(Point2(columns + 0.1, 4.1), Point2(-0.1, 4.1), 20 + 160 * r.nextDouble(), spacing())))
        }
        path = path.append(line(-0.1, 4.1, -0.1, 0.0))
        for (k in 0 until columns) {
            if (r.nextInt(3) == 0) path = path.newLoop().append(closed(k + 0.5, 3.2, 0.3, anyDirection()))
        }
        return path.toDomain(keep)
    }

    private fun opening(x: Double) {
        when (r.nextInt(if (keep) 6 else 5)) {
            0 -> Unit
            1 -> path = path.appendOpening(line(x, 0.0, x, 0.5), closed(x, 0.9, 0.4, Direction.CLOCKWISE))
            2 -> bent(x)
            3 -> hung(x)
            4 -> forked(x)
            else -> deadEnd(x)
        }
    }

    private fun bent(x: Double) {
        val bendX = x + 0.3 * (r.nextDouble() - 0.5)
        path = path.appendConnector(line(x, 0.0, bendX, 0.3)).appendConnector(line(bendX, 0.3, x, 0.6))
            .append(closed(x, 1.0, 0.4, Direction.CLOCKWISE)).back().back()
    }

    /** An opening in two halves; from the node between them a connector leads on to another opening. */
    private fun hung(x: Double) {
        val low = Point2(x, 0.5)
        val high = Point2(x, 1.0)
        path = path.appendConnector(line(x, 0.0, x, 0.5)).append(styled(Arc(low, high, -180.0, spacing())))
            .appendOpening(line(x, 1.0, x, 1.5), closed(x, 1.8, 0.3, Direction.CLOCKWISE))
            .append(styled(Arc(high, low, -180.0, spacing()))).back()
    }

    private fun forked(x: Double) {
        path = path.appendConnector(line(x, 0.0, x, 0.4))
            .appendOpening(line(x, 0.4, x - 0.25, 0.6), closed(x - 0.25, 0.8, 0.2, Direction.CLOCKWISE))
            .appendOpening(line(x, 0.4, x + 0.25, 1.5), closed(x + 0.25, 1.7, 0.2, Direction.CLOCKWISE)).back()
    }

    /** A line that leads nowhere, which only makes sense when it is kept. */
    private fun deadEnd(x: Double) {
        path = path.appendConnector(line(x, 0.0, x + 0.2, 0.7)).appendConnector(line(x + 0.2, 0.7, x - 0.2, 1.2 + r.nextDouble()))
            .back().back()
    }

    private fun line(x0: Double, y0: Double, x1: Double, y1: Double): Line = styled(Line(x0, y0, x1, y1, spacing())) as Line

    /** A closed shape within [radius] of ([x], [y]) that begins at its lowest point. */
    private fun closed(x: Double, y: Double, radius: Double, direction: Direction): Shape {
        val first = Point2(x, y - radius)
        val centre = Point2(x, y)
        return styled(
            when (r.nextInt(4)) {
                0 -> Circle(first, centre, spacing() * radius).withDirection(direction)
                1 -> Polygon(first, centre, 3 + r.nextInt(6), spacing()).withDirection(direction)
                2 -> Ellipse(first, centre, radius * (0.1 + 0.9 * r.nextDouble()), radius, spacing() * radius).withDirection(direction)
                else -> Rectangle(x, y - radius, x + 0.6 * radius, y + 0.5 * radius, spacing()).withDirection(direction)
            },
        )
    }

    private fun anyDirection() = if (r.nextBoolean()) Direction.CLOCKWISE else Direction.ANTICLOCKWISE

    private fun spacing() = StrictMath.pow(10.0, -2 + 2 * r.nextDouble())

    private fun styled(shape: Shape): Shape = shape.withRatio(StrictMath.exp(0.7 * r.nextGaussian()))
        .withDistribution(Distribution.entries[r.nextInt(Distribution.entries.size)])
}
