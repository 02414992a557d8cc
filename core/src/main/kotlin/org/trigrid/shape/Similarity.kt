package org.trigrid.shape

import org.trigrid.geometry.Point2

/**
 * A motion, a change of scale or a reflection of the plane, or several after one another: what keeps circles round.
 *
 * A shape's spacing grows by the scale, so that it keeps its number of nodes. Immutable.
 */
public class Similarity private constructor(
    private val cos: Double,
    private val sin: Double,
    private val flips: Boolean,
    private val dx: Double,
    private val dy: Double,
) {
    /** By how much lengths grow, > 0. */
    @get:JvmName("scale")
    public val scale: Double get() = StrictMath.hypot(cos, sin)

    /** Whether anticlockwise becomes clockwise. */
    @get:JvmName("isReflection")
    public val isReflection: Boolean get() = flips

    /** Where [point] goes. */
    public fun apply(point: Point2): Point2 {
        val turned = applyToDirection(point)
        return Point2(turned.x + dx, turned.y + dy)
    }

    /**
     * Where [shape] goes: a shape of the same class, but for a rectangle that no longer has sides along the axes, which
     * becomes closed lines.
     *
     * @throws org.trigrid.diagnostics.InvalidShapeException if coordinates overflow, or what was apart falls together.
     */
    public fun apply(shape: Shape): Shape {
        val changed = when (shape) {
            is Line -> shape.withEnds(apply(shape.firstPoint), apply(shape.lastPoint))
            is Lines -> shape.withVertices(shape.vertices.map(::apply))
            is Curve -> curve(shape)
            is Rectangle -> rectangle(shape)
            is Polygon -> Polygon(shape.vertices.map(::apply), if (shape.isRegular) apply(shape.centre) else null, shape.traits)
            is Circle -> Circle(apply(shape.firstPoint), apply(shape.centre), direction(shape.direction), shape.traits)
            is Ellipse -> ellipse(shape)
            is Arc -> Arc(apply(shape.firstPoint), apply(shape.lastPoint), if (flips) -shape.angleDegrees else shape.angleDegrees, shape.traits)
        }
        return if (scale == 1.0) changed else changed.withSpacing(shape.spacing * scale)
    }

    /** This one first, [next] after it. */
    public fun then(next: Similarity): Similarity {
        val side = if (next.flips) -1.0 else 1.0
        val shift = next.apply(Point2(dx, dy))
        return Similarity(
            next.cos * cos - side * next.sin * sin,
            next.sin * cos + side * next.cos * sin,
            flips != next.flips, shift.x, shift.y,
        )
    }

    private fun applyToDirection(vector: Point2): Point2 {
        val y = if (flips) -vector.y else vector.y
        return Point2(cos * vector.x - sin * y, sin * vector.x + cos * y)
    }

    private fun direction(value: Direction): Direction = if (flips) value.opposite() else value

    private fun curve(shape: Curve): Curve = Curve(
        shape.vertices.map(::apply), shape.ends,
        shape.beginTangent?.let(::applyToDirection), shape.endTangent?.let(::applyToDirection), shape.traits,
    )

    private fun rectangle(shape: Rectangle): Shape {
        val begin = apply(shape.firstPoint)
        if (sin == 0.0 || cos == 0.0) {
            return Rectangle(begin, apply(shape.endCorner), direction(shape.direction), shape.traits)
        }
        return Lines(shape.corners().dropLast(1).map(::apply) + begin, shape.traits.kind(Lines.KIND))
    }

    private fun ellipse(shape: Ellipse): Ellipse {
        val own = if (flips) -shape.rotationDegrees else shape.rotationDegrees
        return Ellipse(
            apply(shape.firstPoint), apply(shape.centre), shape.radiusX * scale, shape.radiusY * scale,
            own + Turn.of(cos, sin) * FULL_TURN, direction(shape.direction), shape.traits,
        )
    }

    public companion object {
        private const val FULL_TURN = 360.0

        /** Moves by [dx] to the right and [dy] up, in the domain's unit. */
        @JvmStatic
        public fun translation(dx: Double, dy: Double): Similarity = Similarity(1.0, 0.0, false, dx, dy)

        /** Turns anticlockwise about [centre]; exact at multiples of 90 degrees. */
        @JvmStatic
        public fun rotation(centre: Point2, angleDegrees: Double): Similarity =
            about(centre, Turn.cos(angleDegrees / FULL_TURN), Turn.sin(angleDegrees / FULL_TURN), false)

        /**
         * Makes all lengths [factor] times as long, [centre] staying where it is.
         *
         * @throws IllegalArgumentException unless [factor] is a number above 0.
         */
        @JvmStatic
        public fun scaling(centre: Point2, factor: Double): Similarity {
            require(factor > 0 && factor < Double.POSITIVE_INFINITY) { "factor must be a number above 0, not $factor" }
            return about(centre, factor, 0.0, false)
        }

        /**
         * Mirrors on the line through two points.
         *
         * @throws IllegalArgumentException if they are one point.
         */
        @JvmStatic
        public fun reflection(a: Point2, b: Point2): Similarity {
            val ux = b.x - a.x
            val uy = b.y - a.y
            require(ux != 0.0 || uy != 0.0) { "the mirror needs two points, not twice $a" }
            val square = ux * ux + uy * uy
            return about(a, (ux * ux - uy * uy) / square, 2 * ux * uy / square, true)
        }

        private fun about(centre: Point2, cos: Double, sin: Double, flips: Boolean): Similarity {
            val turned = Similarity(cos, sin, flips, 0.0, 0.0).apply(centre)
            return Similarity(cos, sin, flips, centre.x - turned.x, centre.y - turned.y)
        }
    }
}
