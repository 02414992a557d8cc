package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.InvalidShapeException
import kotlin.math.hypot

class EdgeExploderTest {
    private val square = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0)
    private val hole = doubleArrayOf(1.0, 1.0, 2.0, 1.0, 2.0, 2.0, 1.0, 2.0)

    @Test
    fun `nodes stand at the spacing and are numbered along the loops`() {
        val domain = EdgeExploder.explode(Domain.of(square, hole), 0.5)
        assertEquals(2, domain.loopCount)
        assertEquals(32 + 8, domain.nodeCount)
        assertEquals(16.0 - 1.0, domain.area)
        assertTrue(domain.isHole(1))
        assertArrayEquals(IntArray(32) { it }, domain.loopNodes(0))
        for (s in 0 until domain.segmentCount) assertEquals(0.5, length(domain, s), 1e-14)
    }

    @Test
    fun `segments keep their tags and embedded lines stay embedded`() {
        val given = Domain.builder()
            .outer(square, listOf("south", "east", "north", "west"))
            .embed(doubleArrayOf(1.0, 1.0, 3.0, 1.0), "wall")
            .regionName("plate").build()
        val domain = EdgeExploder.explode(given, 1.0)
        assertEquals("plate", domain.regionName)
        val tags = (0 until domain.segmentCount).groupBy { domain.tags[domain.segmentTag(it)] }
        assertEquals(mapOf("south" to 4, "east" to 4, "north" to 4, "west" to 4, "wall" to 2), tags.mapValues { it.value.size })
        assertEquals(tags["wall"], (0 until domain.segmentCount).filter { domain.isEmbedded(it) })
        for (s in tags.getValue("north")) assertEquals(4.0, domain.y(domain.segmentStart(s)))
    }

    @Test
    fun `the ratio is that of the last interval to the first of each segment`() {
        val domain = EdgeExploder.explode(Domain.of(square), 0.5, 3.0)
        assertEquals(3.0, length(domain, 7) / length(domain, 0), 1e-12)
    }

    @Test
    fun `a segment shorter than the spacing stays whole`() {
        val domain = EdgeExploder.explode(Domain.of(square), 100.0)
        assertEquals(4, domain.nodeCount)
    }

    @Test
    fun `faulty segments are left for the check`() {
        val broken = Domain.of(doubleArrayOf(0.0, 0.0, Double.NaN, 0.0, 1.0, 1.0))
        assertEquals(DomainCheck.check(broken).map { it.kind }, DomainCheck.check(EdgeExploder.explode(broken, 10.0)).map { it.kind })
    }

    @Test
    fun `a spacing that is no number above 0 is refused`() {
        for (bad in doubleArrayOf(0.0, -1.0, Double.NaN)) {
            assertThrows(InvalidShapeException::class.java) { EdgeExploder.explode(Domain.of(square), bad) }
        }
    }

    private fun length(domain: Domain, segment: Int): Double {
        val a = domain.segmentStart(segment)
        val b = domain.segmentEnd(segment)
        return hypot(domain.x(b) - domain.x(a), domain.y(b) - domain.y(a))
    }
}
