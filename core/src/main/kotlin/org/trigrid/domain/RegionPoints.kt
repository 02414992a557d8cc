package org.trigrid.domain

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.LinearRing

/** A place in each part of a domain by which its region can be told; for formats that know regions in this way. */
internal object RegionPoints {
    private val FACTORY = GeometryFactory()

    /** One for each face, in the order in which segments come upon them. */
    fun of(domain: Domain): List<RegionMarker> {
        val faces = LineWorkFaces(domain.xy, domain.segments, DoubleArray(0))
        val boundaries = faces.boundaries()
        val isDone = BooleanArray(faces.faceBound)
        val markers = ArrayList<RegionMarker>()
        for (side in domain.segments.indices) {
            val face = faces.faceOf(side)
            val region = if (side % 2 == 0) domain.regionOnLeft(side / 2) else domain.regionOnRight(side / 2)
            if (face < 0 || region < 0 || isDone[face]) continue
            isDone[face] = true
            val rings = boundaries[face].map { ring(domain, it) }
            val point = FACTORY.createPolygon(rings[0], rings.drop(1).toTypedArray()).interiorPoint
            markers.add(RegionMarker(point.x, point.y, domain.regions[region]))
        }
        return markers
    }

    private fun ring(domain: Domain, nodes: IntArray): LinearRing = FACTORY.createLinearRing(
        Array(nodes.size + 1) { Coordinate(domain.x(nodes[it % nodes.size]), domain.y(nodes[it % nodes.size])) },
    )
}
