package org.trigrid.interop

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.locationtech.jts.geom.Geometry
import org.locationtech.jts.geom.MultiPolygon
import org.locationtech.jts.geom.Polygon
import org.locationtech.jts.io.WKTReader
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainCheck

class JtsDomainsTest {
    private val frame = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1))"
    private val several = "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), " +
        "((2 2, 2 4, 4 4, 4 2, 2 2)), ((9 9, 10 9, 10 10, 9 9)))"

    @Test
    fun `there and back`() {
        val domain = JtsDomains.fromPolygon(wkt(frame) as Polygon, "frame")
        assertEquals("frame", domain.regionName)
        assertEquals(32.0, domain.area)
        assertSame(wkt(frame), JtsDomains.toPolygon(domain))
    }

    @Test
    fun `several polygons, each by itself or all as one`() {
        val polygons = wkt(several) as MultiPolygon
        assertEquals(listOf(32.0, 4.0, 0.5), JtsDomains.fromEach(polygons).map { it.area })
        val all = JtsDomains.fromAll(polygons)
        assertEquals(36.5, all.area)
        assertEquals(emptyList<Any>(), DomainCheck.check(all))
        assertEquals(listOf("outer", "hole_1", "2_outer", "3_outer"), all.tags)
        assertEquals(8 + 4 + 3 - 1, all.nodeCount)
        assertSame(polygons, JtsDomains.toMultiPolygon(all))
        assertThrows(IllegalArgumentException::class.java) { JtsDomains.toPolygon(all) }
    }

    @Test
    fun `what has no polygon is refused`() {
        assertThrows(IllegalArgumentException::class.java) { JtsDomains.fromPolygon(wkt("POLYGON EMPTY") as Polygon) }
        val hole = Domain.builder().hole(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0)).build()
        assertThrows(IllegalArgumentException::class.java) { JtsDomains.toMultiPolygon(hole) }
    }

    private fun assertSame(expected: Geometry, actual: Geometry) = assertTrue(expected.norm().equalsExact(actual.norm())) { "$actual" }

    private fun wkt(text: String): Geometry = WKTReader().read(text)
}
