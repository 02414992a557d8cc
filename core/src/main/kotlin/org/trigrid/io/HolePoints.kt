package org.trigrid.io

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.LinearRing
import org.trigrid.domain.Domain
import org.trigrid.domain.LoopRole

/** A point in each hole of a domain, by which Triangle knows it. */
internal object HolePoints {
    private val FACTORY = GeometryFactory()

    /** x0, y0, …, in the order of the holes; within a hole and outside of the islands in it. */
    fun of(domain: Domain): DoubleArray {
        val nesting = Domain.builder()
        for (loop in 0 until domain.loopCount) {
            val xy = coordinates(domain, loop)
            if (domain.isHole(loop)) nesting.hole(xy) else nesting.outer(xy)
        }
        val assembly = nesting.assemble()
        val islands = (0 until domain.loopCount).filter { assembly.role(it) == LoopRole.OUTER }.groupBy { assembly.parentOf(it) }
        val points = ArrayList<Double>()
        for (loop in 0 until domain.loopCount) {
            if (!domain.isHole(loop) || domain.loopStart(loop + 1) - domain.loopStart(loop) < 3) continue
            val inside = islands[loop].orEmpty().map { ring(domain, it) }.toTypedArray()
            val point = FACTORY.createPolygon(ring(domain, loop), inside).interiorPoint
            points.add(point.x)
            points.add(point.y)
        }
        return points.toDoubleArray()
    }

    private fun coordinates(domain: Domain, loop: Int): DoubleArray {
        val nodes = domain.loopNodes(loop)
        return DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) }
    }

    private fun ring(domain: Domain, loop: Int): LinearRing {
        val nodes = domain.loopNodes(loop)
        return FACTORY.createLinearRing(
            Array(nodes.size + 1) { Coordinate(domain.x(nodes[it % nodes.size]), domain.y(nodes[it % nodes.size])) },
        )
    }
}
