package org.trigrid.interop

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.LineString
import org.locationtech.jts.geom.LinearRing
import org.locationtech.jts.geom.MultiPolygon
import org.locationtech.jts.geom.Polygon
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainBuilder
import org.trigrid.domain.LoopRole

/**
 * Domains from the polygons of JTS, and back. Rings may run either way; the tags of their segments are "outer", "hole_1", ….
 * Coordinates are kept bit for bit, third ones left out.
 */
public object JtsDomains {
    /** The domain of one polygon, its region named "domain". */
    @JvmStatic
    public fun fromPolygon(polygon: Polygon): Domain = fromPolygon(polygon, "domain")

    /** @throws IllegalArgumentException if [polygon] is empty. */
    @JvmStatic
    public fun fromPolygon(polygon: Polygon, regionName: String): Domain {
        val builder = Domain.builder().regionName(regionName)
        addRings(builder, polygon, "")
        return builder.build()
    }

    /** One domain for each polygon that is not empty, in their order. */
    @JvmStatic
    public fun fromEach(polygons: MultiPolygon): List<Domain> =
        (0 until polygons.numGeometries).map { polygons.getGeometryN(it) as Polygon }
            .filter { !it.isEmpty }.map { fromPolygon(it) }

    /**
     * One domain with a component for each polygon; the tags of the polygon k > 1 begin with "k_". Polygons that share a node
     * are joined there.
     */
    @JvmStatic
    public fun fromAll(polygons: MultiPolygon): Domain {
        val builder = Domain.builder()
        for (k in 0 until polygons.numGeometries) {
            val polygon = polygons.getGeometryN(k) as Polygon
            if (!polygon.isEmpty) addRings(builder, polygon, if (k == 0) "" else "${k + 1}_")
        }
        return builder.build()
    }

    /**
     * The polygon of a domain with a single outer loop; embedded segments are left out.
     *
     * @throws IllegalArgumentException if the domain has not exactly one outer loop, or loops of fewer than three nodes.
     */
    @JvmStatic
    public fun toPolygon(domain: Domain): Polygon {
        val polygons = toMultiPolygon(domain)
        require(polygons.numGeometries == 1) { "the domain has ${polygons.numGeometries} outer loops, not one" }
        return polygons.getGeometryN(0) as Polygon
    }

    /**
     * One polygon for each outer loop, with the holes in it; embedded segments are left out.
     *
     * @throws IllegalArgumentException if a loop has fewer than three nodes, or a hole lies in no outer loop.
     */
    @JvmStatic
    public fun toMultiPolygon(domain: Domain): MultiPolygon {
        val nesting = Domain.builder()
        for (loop in 0 until domain.loopCount) {
            val xy = coordinates(domain, loop)
            require(xy.size >= 6) { "a ring needs three nodes, loop $loop has ${xy.size / 2}" }
            if (domain.isHole(loop)) nesting.hole(xy) else nesting.outer(xy)
        }
        val assembly = nesting.assemble()
        val holes = HashMap<Int, MutableList<LinearRing>>()
        for (loop in 0 until domain.loopCount) {
            if (assembly.role(loop) == LoopRole.OUTER) continue
            val shell = assembly.parentOf(loop)
            require(shell >= 0 && assembly.role(shell) == LoopRole.OUTER) { "the hole of loop $loop lies in no outer loop" }
            holes.getOrPut(shell) { ArrayList() }.add(ring(domain, loop))
        }
        val shells = (0 until domain.loopCount).filter { assembly.role(it) == LoopRole.OUTER }
        return FACTORY.createMultiPolygon(
            Array(shells.size) { FACTORY.createPolygon(ring(domain, shells[it]), holes[shells[it]].orEmpty().toTypedArray()) },
        )
    }

    private fun addRings(builder: DomainBuilder, polygon: Polygon, prefix: String) {
        require(!polygon.isEmpty) { "the polygon is empty" }
        builder.outer(coordinates(polygon.exteriorRing), prefix + "outer")
        for (i in 0 until polygon.numInteriorRing) {
            builder.hole(coordinates(polygon.getInteriorRingN(i)), "${prefix}hole_${i + 1}")
        }
    }

    /** Rings of JTS always repeat their first point. */
    private fun coordinates(ring: LineString): DoubleArray {
        val sequence = ring.coordinateSequence
        return DoubleArray(2 * (sequence.size() - 1)) { sequence.getOrdinate(it / 2, it % 2) }
    }

    /** x0, y0, x1, y1, … of a loop. */
    internal fun coordinates(domain: Domain, loop: Int): DoubleArray {
        val nodes = domain.loopNodes(loop)
        return DoubleArray(2 * nodes.size) { if (it % 2 == 0) domain.x(nodes[it / 2]) else domain.y(nodes[it / 2]) }
    }

    /** A loop as a closed ring. */
    internal fun ring(domain: Domain, loop: Int): LinearRing {
        val nodes = domain.loopNodes(loop)
        return FACTORY.createLinearRing(
            Array(nodes.size + 1) { Coordinate(domain.x(nodes[it % nodes.size]), domain.y(nodes[it % nodes.size])) },
        )
    }

    private val FACTORY = GeometryFactory()
}
