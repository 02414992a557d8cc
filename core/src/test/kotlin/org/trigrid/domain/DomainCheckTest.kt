package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.Fault
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.FaultKind.CROSSING
import org.trigrid.diagnostics.FaultKind.DEGENERATE_LOOP
import org.trigrid.diagnostics.FaultKind.DUPLICATE_NODE
import org.trigrid.diagnostics.FaultKind.EMBEDDED_OUTSIDE
import org.trigrid.diagnostics.FaultKind.HOLE_OUTSIDE
import org.trigrid.diagnostics.FaultKind.NOT_A_NUMBER
import org.trigrid.diagnostics.FaultKind.OPEN_WALK
import org.trigrid.diagnostics.FaultKind.OVERLAP
import org.trigrid.diagnostics.FaultKind.SPIKE
import org.trigrid.diagnostics.FaultKind.TOUCHING
import org.trigrid.diagnostics.FaultKind.ZERO_LENGTH
import org.trigrid.diagnostics.InvalidDomainException

class DomainCheckTest {
    @Test
    fun `valid domains have no faults`() {
        assertFaults(outer())
        assertFaults(outer().hole(square(1.0, 1.0, 2.0)).outer(square(1.5, 1.5, 1.0)))
        assertFaults(outer().outer(square(20.0, 0.0, 2.0)))
        assertFaults(outer().outer(square(10.0, 10.0, 2.0)))
        assertFaults(outer().hole(doubleArrayOf(0.0, 0.0, 3.0, 1.0, 1.0, 3.0)).hole(doubleArrayOf(3.0, 1.0, 6.0, 3.0, 3.0, 6.0)))
        assertFaults(outer().hole(square(4.0, 4.0, 2.0)).embed(doubleArrayOf(0.0, 0.0, 2.0, 3.0, 4.0, 4.0), "line"))
        assertFaults(outer().embed(doubleArrayOf(0.0, 0.0, 10.0, 10.0), "line").embed(doubleArrayOf(1.0, 2.0, 2.0, 3.0), "line"))
    }

    @Test
    fun `not a number`() {
        val faults = assertFaults(Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1.0, 0.0, Double.NaN, 1.0)), NOT_A_NUMBER)
        assertEquals(listOf(2), faults[0].nodes().toList())
        assertFaults(outer().hole(doubleArrayOf(1.0, 1.0, 2.0, 1.0, 1.0, Double.NEGATIVE_INFINITY)), NOT_A_NUMBER)
    }

    @Test
    fun `coordinates that cannot be computed with are refused`() {
        val large = assertFaults(outer().outer(doubleArrayOf(20.0, 0.0, 1e61, 0.0, 20.0, 5.0)), NOT_A_NUMBER)
        assertTrue("beyond 1e60" in large.single().message)
        val short = assertFaults(Domain.builder().outer(doubleArrayOf(0.0, 0.0, 1e-61, 0.0, 4.0, 0.0, 0.0, 4.0)), ZERO_LENGTH)
        assertTrue("shorter than 1e-60" in short.single().message)
        for (scale in listOf(1e-320, 1e-200, 1e-62, 1e61, 1e200, 1e307)) {
            val faults = DomainCheck.check(Domain.of(doubleArrayOf(0.0, 0.0, scale, 0.0, scale, scale, 0.0, scale)))
            assertTrue(faults.any { it.kind == if (scale < 1) ZERO_LENGTH else NOT_A_NUMBER }) { "$scale: $faults" }
        }
        for (scale in listOf(1e-58, 1e58)) assertFaults(Domain.builder().outer(square(0.0, 0.0, scale)))
    }

    @Test
    fun `crossing tells the place`() {
        val faults = assertFaults(Domain.builder().outer(doubleArrayOf(0.0, 0.0, 4.0, 4.0, 4.0, 0.0, 0.0, 4.0)), CROSSING, DEGENERATE_LOOP)
        val crossing = faults.single { it.kind == CROSSING }
        assertEquals(2.0, crossing.x)
        assertEquals(2.0, crossing.y)
        assertEquals(setOf(0, 1, 2, 3), crossing.nodes().toSet())
        assertTrue(crossing.message.contains("(2.0, 2.0)"))
        assertFaults(outer().hole(doubleArrayOf(5.0, 5.0, 12.0, 5.0, 5.0, 6.0)), CROSSING)
        assertFaults(outer().embed(doubleArrayOf(5.0, 5.0, 12.0, 6.0), "line"), CROSSING)
    }

    @Test
    fun `touching tells node and segment once`() {
        val faults = assertFaults(outer().hole(doubleArrayOf(5.0, 0.0, 6.0, 2.0, 4.0, 2.0)), TOUCHING)
        assertEquals(listOf(4, 0, 1), faults.single().nodes().toList())
        assertFaults(outer().embed(doubleArrayOf(5.0, 5.0, 10.0, 5.0), "line"), TOUCHING)
    }

    @Test
    fun `duplicate node`() {
        val domain = walk(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 2.0, 2.0, -0.0, 0.0), intArrayOf(0, 1, 2), intArrayOf())
        assertFaults(domain)
        val torn = walk(
            doubleArrayOf(0.0, 0.0, 8.0, 0.0, 0.0, 8.0, 1.0, 1.0, 1.0, 2.0, 2.0, 1.0, 0.0, 0.0),
            intArrayOf(0, 1, 2), intArrayOf(6, 4, 5),
        )
        val faults = assertFaults(torn, DUPLICATE_NODE)
        assertEquals(listOf(0, 5), faults.single().nodes().toList())
    }

    @Test
    fun `zero length`() {
        val builder = Domain.builder().outer(doubleArrayOf(0.0, 0.0, 4.0, 0.0, 4.0, 0.0, 4.0, 4.0))
        val fault = assertFaults(builder, ZERO_LENGTH).single()
        assertEquals(listOf(1, 1), fault.nodes().toList())
        assertEquals(4.0, fault.x)
        assertFaults(Domain.builder().outer(doubleArrayOf(3.0, 3.0)).outer(square(0.0, 0.0, 1.0)), ZERO_LENGTH, DEGENERATE_LOOP)
    }

    @Test
    fun `spike`() {
        val there = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 4.0, 1.0, 6.0, 1.0, 4.0, 1.0, 4.0, 4.0, 0.0, 4.0)
        assertEquals(6.0, assertFaults(Domain.builder().outer(there), SPIKE).single().x)
        val shorter = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 6.0, 0.0, 5.0, 0.0, 4.0, 4.0)
        assertTrue(SPIKE in DomainCheck.check(Domain.builder().outer(shorter).build()).map { it.kind })
        val long = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 5.0, 1.0, 6.0, 1.0, 5.0, 1.0, 4.0, 0.0, 0.0, 4.0)
        assertEquals(6.0, assertFaults(Domain.builder().outer(long), SPIKE).single().x)
        assertFaults(walk(doubleArrayOf(0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 1.0, 1.0), intArrayOf(0, 3, 0, 1, 2), intArrayOf()), SPIKE)
    }

    @Test
    fun `overlap`() {
        assertFaults(Domain.builder().outer(square(0.0, 0.0, 4.0)).outer(square(4.0, 0.0, 4.0)), OVERLAP)
        assertFaults(outer().outer(square(2.0, 2.0, 1.0)), OVERLAP)
        assertFaults(outer().outer(square(0.0, 0.0, 10.0)), OVERLAP)
        assertFaults(outer().hole(doubleArrayOf(2.0, 0.0, 4.0, 0.0, 3.0, 2.0)), OVERLAP)
        assertFaults(outer().embed(doubleArrayOf(0.0, 0.0, 10.0, 0.0), "line"), OVERLAP)
        val inNode = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 2.0, 2.0)
        assertFaults(Domain.builder().outer(inNode).outer(doubleArrayOf(0.0, 0.0, 2.0, 0.5, 6.0, 9.0, -1.0, 9.0)), CROSSING, OVERLAP)
        val throughNodes = doubleArrayOf(2.0, 0.0, 4.0, 2.0, 2.0, 4.0, 0.0, 2.0)
        val other = doubleArrayOf(2.0, 0.0, 4.0, 2.0, 5.0, 5.0, 2.0, 4.0, 1.0, 2.0)
        assertFaults(Domain.builder().outer(throughNodes).outer(other), OVERLAP)
    }

    @Test
    fun `open walk`() {
        val xy = doubleArrayOf(0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 1.0, 1.0, 2.0, 1.0)
        val domain = Domain(xy, intArrayOf(0, 1, 1, 2, 2, 0, 3, 4), IntArray(4), BooleanArray(4), listOf("b"), "r")
        assertEquals(listOf(3, 4), assertFaults(domain, OPEN_WALK).map { it.nodes()[0] })
    }

    @Test
    fun `hole outside`() {
        assertFaults(outer().hole(square(20.0, 0.0, 2.0)), HOLE_OUTSIDE)
        assertFaults(Domain.builder().hole(square(20.0, 0.0, 2.0)), HOLE_OUTSIDE)
        assertFaults(outer().hole(square(2.0, 2.0, 6.0)).hole(square(3.0, 3.0, 1.0)), HOLE_OUTSIDE)
        assertFaults(outer().hole(doubleArrayOf(0.0, 0.0, -2.0, -1.0, -1.0, -2.0)), HOLE_OUTSIDE)
    }

    @Test
    fun `degenerate loop`() {
        assertFaults(outer().hole(doubleArrayOf(1.0, 1.0, 2.0, 2.0)), DEGENERATE_LOOP)
        assertFaults(Domain.builder(), DEGENERATE_LOOP)
        val flat = outer().hole(doubleArrayOf(1.0, 1.0, 2.0, 2.0, 3.0, 3.0))
        assertTrue(DEGENERATE_LOOP in DomainCheck.check(flat.build()).map { it.kind })
    }

    @Test
    fun `embedded outside`() {
        assertFaults(outer().embed(doubleArrayOf(20.0, 1.0, 21.0, 1.0), "line"), EMBEDDED_OUTSIDE)
        assertFaults(outer().hole(square(2.0, 2.0, 2.0)).embed(doubleArrayOf(2.0, 2.0, 3.0, 3.0), "line"), EMBEDDED_OUTSIDE)
        assertFaults(outer().hole(square(2.0, 2.0, 2.0)).embed(doubleArrayOf(2.0, 2.0, 4.0, 4.0), "line"), EMBEDDED_OUTSIDE)
    }

    @Test
    fun `all faults are told at once, by their first nodes`() {
        val builder = outer()
            .hole(square(20.0, 0.0, 2.0))
            .hole(doubleArrayOf(5.0, 5.0, 12.0, 5.0, 5.0, 6.0))
            .hole(doubleArrayOf(5.0, 0.0, 6.0, 2.0, 4.0, 2.0))
            .hole(doubleArrayOf(1.0, 1.0, 1.0, Double.NaN, 2.0, 1.0))
            .hole(doubleArrayOf(1.0, 6.0, 2.0, 6.0, 2.0, 6.0, 1.0, 7.0))
            .embed(doubleArrayOf(30.0, 1.0, 31.0, 1.0), "line")
        val faults = assertFaults(builder, HOLE_OUTSIDE, CROSSING, TOUCHING, NOT_A_NUMBER, ZERO_LENGTH, EMBEDDED_OUTSIDE)
        assertEquals(faults.map { it.nodes()[0] }.sorted(), faults.map { it.nodes()[0] })
        val thrown = assertThrows(InvalidDomainException::class.java) { DomainCheck.requireValid(builder.build()) }
        assertEquals(faults.size, thrown.faults.size)
    }

    @Test
    fun `a flood of faults is cut short, but no kind is lost`() {
        val builder = outer().hole(square(30.0, 0.0, 1.0))
        val comb = ArrayList<Double>()
        for (i in 0 until 3000) comb.addAll(listOf(50.0 + i, 0.0, 50.5 + i, 2.0))
        builder.outer((comb + listOf(4000.0, 1.0, 40.0, 1.0)).toDoubleArray())
        val faults = DomainCheck.check(builder.build())
        assertTrue(faults.size <= 1010)
        assertTrue(HOLE_OUTSIDE in faults.map { it.kind })
        assertTrue(faults.any { it.kind == CROSSING && it.message.contains("5000 more") || it.message.contains("more faults") })
    }

    private fun assertFaults(builder: DomainBuilder, vararg kinds: FaultKind) = assertFaults(builder.build(), *kinds)

    private fun assertFaults(domain: Domain, vararg kinds: FaultKind): List<Fault> {
        val faults = DomainCheck.check(domain)
        assertEquals(kinds.toSet(), faults.map { it.kind }.toSet()) { faults.joinToString("\n") }
        return faults
    }

    private fun walk(xy: DoubleArray, vararg walks: IntArray): Domain {
        val used = walks.filter { it.isNotEmpty() }
        return Domain.fromWalks(xy, used, used.map { IntArray(it.size) }, listOf("b"), "r", false)
    }

    private fun outer() = Domain.builder().outer(square(0.0, 0.0, 10.0))

    private fun square(x: Double, y: Double, side: Double) =
        doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)
}
