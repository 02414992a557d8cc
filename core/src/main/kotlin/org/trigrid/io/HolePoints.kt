package org.trigrid.io

import org.locationtech.jts.geom.GeometryFactory
import org.trigrid.domain.Domain
import org.trigrid.domain.LoopRole
import org.trigrid.interop.JtsDomains

/** A point in each hole of a domain, by which Triangle knows it. */
internal object HolePoints {
    private val FACTORY = GeometryFactory()

    /** x0, y0, …, in the order of the holes; within a hole and outside of the islands in it. */
    fun of(domain: Domain): DoubleArray {
        val nesting = Domain.builder()
        for (loop in 0 until domain.loopCount) {
            val xy = JtsDomains.coordinates(domain, loop)
            if (domain.isHole(loop)) nesting.hole(xy) else nesting.outer(xy)
        }
        val assembly = nesting.assemble()
        val islands = (0 until domain.loopCount).filter { assembly.role(it) == LoopRole.OUTER }.groupBy { assembly.parentOf(it) }
        val points = ArrayList<Double>()
        for (loop in 0 until domain.loopCount) {
            if (!domain.isHole(loop) || domain.loopStart(loop + 1) - domain.loopStart(loop) < 3) continue
            val inside = islands[loop].orEmpty().map { JtsDomains.ring(domain, it) }.toTypedArray()
            val point = FACTORY.createPolygon(JtsDomains.ring(domain, loop), inside).interiorPoint
            points.add(point.x)
            points.add(point.y)
        }
        return points.toDoubleArray()
    }
}
