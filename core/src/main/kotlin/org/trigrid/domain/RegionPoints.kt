package org.trigrid.domain

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.LinearRing

/** A part of a domain: a face of its line work that is meshed. */
internal class RegionPart(
    /** Index into the domain's regions. */
    val region: Int,
    /** Nodes along its boundaries: the outer one, then those of what lies in it. Not modified. */
    val boundaries: List<IntArray>,
)

/** The parts of a domain, in the order in which segments come upon them. */
internal fun Domain.parts(): List<RegionPart> {
    val faces = LineWorkFaces(xy, segments, DoubleArray(0))
    val boundaries = faces.boundaries()
    val isDone = BooleanArray(faces.faceBound)
    val parts = ArrayList<RegionPart>()
    for (side in segments.indices) {
        val face = faces.faceOf(side)
        val region = if (side % 2 == 0) regionOnLeft(side / 2) else regionOnRight(side / 2)
        if (face < 0 || region < 0 || isDone[face]) continue
        isDone[face] = true
        parts.add(RegionPart(region, boundaries[face]))
    }
    return parts
}

/** A place in each part of a domain by which its region can be told; for formats that know regions in this way. */
internal object RegionPoints {
    private val FACTORY = GeometryFactory()

    /** One for each part. */
    fun of(domain: Domain): List<RegionMarker> = domain.parts().map { part ->
        val rings = part.boundaries.map { ring(domain, it) }
        val point = FACTORY.createPolygon(rings[0], rings.drop(1).toTypedArray()).interiorPoint
        RegionMarker(point.x, point.y, domain.regions[part.region])
    }

    private fun ring(domain: Domain, nodes: IntArray): LinearRing = FACTORY.createLinearRing(
        Array(nodes.size + 1) { Coordinate(domain.x(nodes[it % nodes.size]), domain.y(nodes[it % nodes.size])) },
    )
}
