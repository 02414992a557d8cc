package org.trigrid.shape

import org.trigrid.geometry.Point2
import java.util.Random

/** One random shape of each kind, a few hundred nodes at most. */
internal fun randomShapes(random: Random): List<Shape> {
    fun number() = random.nextGaussian() * 10
    fun point() = Point2(number(), number())
    fun points(count: Int) = List(count) { point() }
    val direction = if (random.nextBoolean()) Direction.CLOCKWISE else Direction.ANTICLOCKWISE
    val spacing = 0.5 + 3 * random.nextDouble()
    val plain = listOf(
        Line(point(), point(), spacing),
        Lines(points(2 + random.nextInt(5)), spacing),
        Curve(points(2 + random.nextInt(6)), spacing),
        Curve(points(3 + random.nextInt(6)), spacing).closed(),
        Curve(points(2 + random.nextInt(6)), spacing).clamped(point(), point()),
        Rectangle(point(), point(), spacing).withDirection(direction),
        Polygon(point(), point(), 3 + random.nextInt(6), spacing).withDirection(direction),
        Polygon(points(3 + random.nextInt(6)), spacing),
        Circle(point(), point(), spacing).withDirection(direction),
        Ellipse(number(), number(), 0.1 + Math.abs(number()), 0.1 + Math.abs(number()), spacing)
            .withRotationDegrees(number() * 36).withFirstPointTowards(point()).withDirection(direction),
        Arc(point(), point(), (random.nextDouble() * 2 - 1) * 350, spacing),
    )
    return plain.map {
        it.withRatio(StrictMath.exp(random.nextGaussian()))
            .withDistribution(Distribution.entries[random.nextInt(3)])
            .withRounding(Rounding.entries[random.nextInt(2)])
            .withName("shape ${random.nextInt(9)}")
    }
}
