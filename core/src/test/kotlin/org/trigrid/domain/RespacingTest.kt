package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.InvalidShapeException

class RespacingTest {
    private val plate = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 2.0, 0.0, 2.0), listOf("a", "b", "c", "d"))
        .hole(doubleArrayOf(1.0, 1.0, 2.0, 1.0, 1.0, 1.5), "hole").embed(doubleArrayOf(0.0, 0.0, 0.5, 0.5), "line").build()

    @Test
    fun `each edge gets the intervals that fit best and corners stay`() {
        val fine = plate.respaced(0.29, 1.0)
        assertEquals(listOf(10, 7, 10, 7), listOf("a", "b", "c", "d").map { tag -> count(fine, tag) })
        assertEquals(3 + 2 + 4, count(fine, "hole"))
        assertEquals(2, count(fine, "line"))
        assertArrayEquals(plate.xy, fine.xy.copyOf(plate.xy.size))
        assertEquals(plate.area, fine.area, 1e-14)
        assertEquals(emptyList<Any>(), DomainCheck.check(fine))
        assertEquals(2, fine.loopCount)
    }

    @Test
    fun `the last interval is the ratio times the first`() {
        val graded = plate.respaced(0.3, 4.0)
        val lengths = (0 until 10).map { graded.x(graded.segmentEnd(it)) - graded.x(graded.segmentStart(it)) }
        assertEquals(4.0, lengths.last() / lengths.first(), 1e-12)
        for (i in 1 until 9) assertEquals(lengths[i + 1] - lengths[i], lengths[i] - lengths[i - 1], 1e-12)
    }

    @Test
    fun `an edge gives the same nodes in both directions`() {
        val a = Domain.of(doubleArrayOf(0.1, 0.2, 7.3, 1.7, 0.0, 9.0)).respaced(0.37, 2.5)
        val b = Domain.of(doubleArrayOf(0.1, 0.2, 7.3, 1.7, 0.0, -9.0)).respaced(0.37, 1 / 2.5)
        val shared = (3 until a.nodeCount).map { a.x(it) to a.y(it) }.toSet() intersect (3 until b.nodeCount).map { b.x(it) to b.y(it) }.toSet()
        assertEquals(19, shared.size)
    }

    @Test
    fun `a wide spacing changes nothing and a bad one is refused`() {
        assertArrayEquals(plate.segments, plate.respaced(100.0, 3.0).segments)
        for (bad in listOf(0.0, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(InvalidShapeException::class.java) { plate.respaced(bad, 1.0) }
            assertThrows(InvalidShapeException::class.java) { plate.respaced(1.0, bad) }
        }
        assertThrows(InvalidShapeException::class.java) { plate.respaced(1e-12, 1.0) }
    }

    private fun count(domain: Domain, tag: String) = (0 until domain.segmentCount).count { domain.tags[domain.segmentTag(it)] == tag }
}
