package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.Frame

/**
 * Finds the frames that move and turn with a domain: about the mean of its nodes, in the direction of its segments, on grids of
 * 2^-34 of its size and finer. The direction is told up to quarter turns; [ExactPose] decides between them, and whether to mirror.
 *
 * The direction is that to which the segments are parallel or at right angles, in the mean by their lengths: that of
 * sum l exp(4 i t). So what is drawn along the axes stays along them. Where segments have none, it is that of the nodes' moments,
 * or if they have none either, as on circles, that of a node of the [PolarOrder].
 */
internal class DomainFrame(private val domain: Domain, private val checkpoint: Checkpoint) {
    private var centreX = 0.0
    private var centreY = 0.0

    /** Root of the mean square of the nodes' distances from the centre. */
    private var radius = 0.0
    private var shortest = Double.POSITIVE_INFINITY

    /** On grids from coarse to fine; none for a domain of many nodes, and none with a grid that is too coarse for its segments. */
    fun frames(): List<Frame> {
        if (domain.nodeCount > MOST_NODES) return emptyList()
        findCentre()
        findRadius()
        val angle = Math.IEEEremainder(direction(), QUARTER)
        val isAlongAxes = Math.abs(angle) < AXIS
        val cos = if (isAlongAxes) 1.0 else StrictMath.cos(angle)
        val sin = if (isAlongAxes) 0.0 else StrictMath.sin(angle)
        // The factor keeps the sizes that are common off the values at which the step changes.
        val exponent = Math.getExponent(OFF_COMMON * radius)
        val rounding = Math.ulp(OFF_COMMON * (StrictMath.hypot(centreX, centreY) + radius))
        return GRIDS.indices.map { Math.max(Math.scalb(1.0, exponent - GRIDS[it]), ULPS[it] * rounding) }
            .filter { shortest >= LEAST_STEPS * it }.map { Frame(centreX, centreY, cos, sin, it) }
    }

    private fun findCentre() {
        // Relative to a node, as far from the origin the sums would lose the places.
        val x0 = domain.x(0)
        val y0 = domain.y(0)
        var sumX = 0.0
        var sumY = 0.0
        for (node in 0 until domain.nodeCount) {
            checkpoint.pass()
            sumX += domain.x(node) - x0
            sumY += domain.y(node) - y0
        }
        centreX = x0 + sumX / domain.nodeCount
        centreY = y0 + sumY / domain.nodeCount
    }

    private fun findRadius() {
        var sum = 0.0
        for (node in 0 until domain.nodeCount) {
            checkpoint.pass()
            val x = domain.x(node) - centreX
            val y = domain.y(node) - centreY
            sum += x * x + y * y
        }
        radius = Math.sqrt(sum / domain.nodeCount)
    }

    /** An angle that turns with the domain, to be taken up to quarter turns. */
    private fun direction(): Double {
        var real = 0.0
        var imaginary = 0.0
        var total = 0.0
        for (s in 0 until domain.segmentCount) {
            checkpoint.pass()
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            val x = domain.x(b) - domain.x(a)
            val y = domain.y(b) - domain.y(a)
            val square = x * x + y * y
            val length = Math.sqrt(square)
            shortest = Math.min(shortest, length)
            total += length
            val cos = (x * x - y * y) / square
            val sin = 2 * x * y / square
            real += length * (cos * cos - sin * sin)
            imaginary += length * (2 * cos * sin)
        }
        if (real * real + imaginary * imaginary >= NOTABLE * NOTABLE * total * total) {
            return StrictMath.atan2(imaginary, real) / 4
        }
        val moments = NodeMoments(domain, checkpoint)
        val isTold = moments.phaseCount > 0 && 4 % moments.phaseCount == 0
        return if (isTold) moments.phase else PolarOrder(domain, centreX, centreY, radius, checkpoint).direction()
    }

    private companion object {
        /** Beyond, equal choices are so many that their mean is the same however the domain lies. */
        const val MOST_NODES = 20_000

        /** Coarse against the rounding of coordinates, fine against what is meshed; then one for very fine figures. */
        val GRIDS = intArrayOf(34, 42)

        /** Steps are at least so many times what coordinates far from the origin are rounded by. Powers of two. */
        val ULPS = doubleArrayOf(4096.0, 16.0)

        /** Of the grid, in the shortest segment. */
        const val LEAST_STEPS = 64.0

        const val OFF_COMMON = 1.37
        const val QUARTER = Math.PI / 2

        /** Smaller angles are rounding errors, and below the grid. */
        const val AXIS = 1e-12

        /** Share of the lengths' sum from which the segments have a direction. */
        const val NOTABLE = 0.05
    }
}
