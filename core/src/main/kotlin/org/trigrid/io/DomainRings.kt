package org.trigrid.io

import org.locationtech.jts.geom.LineString
import org.locationtech.jts.geom.Polygon
import org.trigrid.domain.Domain
import org.trigrid.interop.JtsDomains

/** The polygons of a domain as rings of coordinates. */
internal object DomainRings {
    /**
     * For each outer loop its ring, anticlockwise, and those of its holes, clockwise: x0, y0, …, the first point not repeated.
     *
     * @throws IllegalArgumentException if the domain has faults that keep it from being polygons.
     */
    fun polygons(domain: Domain): List<List<DoubleArray>> {
        val polygons = JtsDomains.toMultiPolygon(domain)
        return (0 until polygons.numGeometries).map { i ->
            val polygon = polygons.getGeometryN(i) as Polygon
            listOf(ring(polygon.exteriorRing)) + (0 until polygon.numInteriorRing).map { ring(polygon.getInteriorRingN(it)) }
        }
    }

    private fun ring(ring: LineString): DoubleArray {
        val sequence = ring.coordinateSequence
        return DoubleArray(2 * (sequence.size() - 1)) { sequence.getOrdinate(it / 2, it % 2) }
    }
}
