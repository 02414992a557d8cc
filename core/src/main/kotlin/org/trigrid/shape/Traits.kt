package org.trigrid.shape

import org.trigrid.diagnostics.InvalidShapeException
import org.trigrid.geometry.Point2

/**
 * What all shapes have in common: how they are exploded and what they are called.
 *
 * @param kind the shape's word in messages, such as `circle`.
 */
internal class Traits(
    val kind: String,
    val spacing: Double,
    val ratio: Double = 1.0,
    val distribution: Distribution = Distribution.LINEAR,
    val rounding: Rounding = Rounding.NEAREST,
    val name: String = "",
) {
    init {
        positive(kind, "spacing", spacing)
        positive(kind, "ratio", ratio)
        if (1 / ratio == Double.POSITIVE_INFINITY) refuse(kind, "ratio $ratio is too small")
        checkName()
    }

    /** For a shape that became one of another kind. */
    fun kind(value: String): Traits = Traits(value, spacing, ratio, distribution, rounding, name)

    fun spacing(value: Double): Traits = Traits(kind, value, ratio, distribution, rounding, name)

    fun ratio(value: Double): Traits = Traits(kind, spacing, value, distribution, rounding, name)

    fun distribution(value: Distribution): Traits = Traits(kind, spacing, ratio, value, rounding, name)

    fun rounding(value: Rounding): Traits = Traits(kind, spacing, ratio, distribution, value, name)

    fun name(value: String): Traits = Traits(kind, spacing, ratio, distribution, rounding, value)

    /** For the same nodes in the opposite order. */
    fun reversed(): Traits = if (distribution == Distribution.SYMMETRIC) this else ratio(1 / ratio)

    /** Mesh files quote names and limit their length, so what they cannot hold is refused where it is given. */
    private fun checkName() {
        if (name.length > MAX_NAME_LENGTH) refuse(kind, "name is longer than $MAX_NAME_LENGTH characters")
        if (name.any { it == '"' || it.isISOControl() }) refuse(kind, "name holds a quote or a control character")
    }

    fun key(): List<Any> = listOf(spacing, ratio, distribution, rounding, name)

    companion object {
        private const val MAX_NAME_LENGTH = 127

        fun refuse(kind: String, reason: String): Nothing = throw InvalidShapeException("$kind: $reason")

        fun positive(kind: String, field: String, value: Double) {
            if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
                refuse(kind, "$field must be a number above 0, not $value")
            }
        }

        fun finite(kind: String, field: String, value: Double) {
            if (!value.isFinite()) refuse(kind, "$field must be a number, not $value")
        }

        fun finite(kind: String, field: String, point: Point2) {
            if (!point.x.isFinite() || !point.y.isFinite()) refuse(kind, "$field must have numbers, not $point")
        }

        /** Vertices are at least [least] finite points, no two neighbours alike. */
        fun vertices(kind: String, vertices: List<Point2>, least: Int, closed: Boolean): List<Point2> {
            if (vertices.size < least) refuse(kind, "vertices must be at least $least, not ${vertices.size}")
            for (i in vertices.indices) {
                finite(kind, "vertex $i", vertices[i])
                val next = if (i + 1 < vertices.size) i + 1 else if (closed) 0 else break
                if (samePlace(vertices[i], vertices[next])) refuse(kind, "vertices $i and $next are the same place")
            }
            return java.util.List.copyOf(vertices)
        }

        fun samePlace(a: Point2, b: Point2): Boolean = a.x == b.x && a.y == b.y

        /** Points from x0, y0, x1, y1, … */
        fun points(kind: String, coordinates: DoubleArray): List<Point2> {
            if (coordinates.size % 2 != 0) refuse(kind, "coordinates must come in pairs, not ${coordinates.size} numbers")
            return List(coordinates.size / 2) { Point2(coordinates[2 * it], coordinates[2 * it + 1]) }
        }
    }
}
