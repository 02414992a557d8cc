package org.trigrid.front

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshGenerator
import org.trigrid.MeshOptions
import org.trigrid.diagnostics.ProgressMonitor
import org.trigrid.domain.Domain
import org.trigrid.domain.Path
import org.trigrid.geometry.Predicates
import org.trigrid.shape.Circle
import org.trigrid.shape.Rectangle

class FrontTraceTest {
    private val plate = Path.of(Rectangle(0.0, 0.0, 4.0, 3.0, 0.4)).newLoop().append(Circle(2.0, 1.5, 0.7, 0.2)).toDomain()
    private val slit = Domain.builder().loop(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 3.0, 0.0, 3.0, 1.0, 3.0, 2.0, 2.0, 2.0, 1.0, 2.0, 0.0, 2.0, 0.0, 1.0))
        .embed(doubleArrayOf(1.0, 1.0, 2.0, 1.0), "slit").build()

    @Test
    fun `the front begins as the boundary and ends as nothing`() {
        for (domain in listOf(plate, slit)) for (strategy in Strategy.entries) {
            val trace = traced(domain, strategy)
            val twice = (0 until domain.segmentCount).count { domain.isEmbedded(it) }
            assertEquals(2 * (domain.segmentCount + twice), trace.frontAfter(0).size)
            assertEquals(0, trace.frontAfter(trace.elementCount).size)
            assertThrows(IndexOutOfBoundsException::class.java) { trace.frontAfter(trace.elementCount + 1) }
        }
    }

    @Test
    fun `the front may be asked for in any order`() {
        val trace = traced(plate, Strategy.ROBUST)
        val forward = (0..trace.elementCount).map { trace.frontAfter(it) }
        for (count in listOf(7, 3, trace.elementCount, 0, 12)) assertArrayEquals(forward[count], trace.frontAfter(count))
    }

    @Test
    fun `each element stands on a side of the front, and what it covers is the front's no more`() {
        for (strategy in Strategy.entries) {
            val trace = traced(plate, strategy)
            var left = plate.area
            for (element in 0 until trace.elementCount) {
                val (a, b, c) = (0..2).map { trace.nodeOf(element, it) }
                assertTrue((a to b) in sides(trace, element))
                assertTrue(Predicates.orient(trace.x(a), trace.y(a), trace.x(b), trace.y(b), trace.x(c), trace.y(c)) > 0)
                left -= area(trace, a, b, c)
                val open = sides(trace, element + 1).sumOf { (p, q) -> trace.x(p) * trace.y(q) - trace.x(q) * trace.y(p) } / 2
                assertEquals(left, open, 1e-9)
            }
        }
    }

    @Test
    fun `a listener does not change the mesh`() {
        val trace = FrontTrace(plate)
        val heard = MeshGenerator.generate(plate, MeshOptions.DEFAULT, ProgressMonitor.NONE, trace).mesh
        val unheard = MeshGenerator.generate(plate).mesh
        assertArrayEquals(unheard.nodeCoordinates(), heard.nodeCoordinates())
        assertArrayEquals(unheard.elementNodes(), heard.elementNodes())
        assertTrue(trace.elementCount > 20)
    }

    private fun traced(domain: Domain, strategy: Strategy): FrontTrace {
        val trace = FrontTrace(domain)
        val options = MeshOptions.builder().strategy(strategy).build()
        MeshGenerator.generate(domain, options, ProgressMonitor.NONE, trace)
        return trace
    }

    private fun sides(trace: FrontTrace, count: Int): List<Pair<Int, Int>> =
        trace.frontAfter(count).asList().chunked(2).map { (a, b) -> a to b }

    private fun area(trace: FrontTrace, a: Int, b: Int, c: Int): Double =
        ((trace.x(b) - trace.x(a)) * (trace.y(c) - trace.y(a)) - (trace.y(b) - trace.y(a)) * (trace.x(c) - trace.x(a))) / 2
}
