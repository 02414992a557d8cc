package org.trigrid.spacing

import org.locationtech.jts.algorithm.RayCrossingCounter
import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.Location
import org.locationtech.jts.index.intervalrtree.SortedPackedIntervalRTree
import org.trigrid.domain.Domain

/** Tells whether places lie in a domain, its boundary included; exact, by counting crossings of a ray. */
internal class InsideLocator(domain: Domain) {
    private val segmentsByY = SortedPackedIntervalRTree()

    init {
        for (s in 0 until domain.segmentCount) {
            if (domain.isEmbedded(s)) continue
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            val ends = arrayOf(Coordinate(domain.x(a), domain.y(a)), Coordinate(domain.x(b), domain.y(b)))
            segmentsByY.insert(Math.min(ends[0].y, ends[1].y), Math.max(ends[0].y, ends[1].y), ends)
        }
    }

    fun isInside(x: Double, y: Double): Boolean {
        val counter = RayCrossingCounter(Coordinate(x, y))
        segmentsByY.query(y, y) { item ->
            val ends = item as Array<*>
            counter.countSegment(ends[0] as Coordinate, ends[1] as Coordinate)
        }
        return counter.location != Location.EXTERIOR
    }
}
