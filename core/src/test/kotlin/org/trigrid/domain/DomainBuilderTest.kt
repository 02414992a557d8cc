package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.random.Random

class DomainBuilderTest {
    @Test
    fun `loops in any direction get the domain on their left`() {
        for (flips in 0 until 8) {
            val assembly = Domain.builder()
                .outer(turned(square(0.0, 0.0, 10.0), flips and 1), "edge")
                .hole(turned(square(2.0, 2.0, 6.0), flips and 2), "hole")
                .outer(turned(square(4.0, 4.0, 1.0), flips and 4), "island")
                .assemble()
            assertEquals(100.0 - 36.0 + 1.0, assembly.domain.area)
            assertArrayEquals(
                listOf(0, 1, 2).filter { (flips and (1 shl it) != 0) != (it == 1) }.toIntArray(),
                assembly.reversedLoops(),
            )
            assertEquals(listOf(false, true, false), (0..2).map { assembly.domain.isHole(it) })
            assertArrayEquals(intArrayOf(-1, 0, 1), (0..2).map { assembly.parentOf(it) }.toIntArray())
        }
    }

    @Test
    fun `roles are found out at any depth and in any order`() {
        val random = Random(1)
        repeat(20) {
            val depth = 1 + random.nextInt(12)
            val rings = (0 until depth).map { square(it.toDouble(), it.toDouble(), 100.0 - 2 * it) }
            val apart = (0 until depth).map { square(200.0 + it, it.toDouble(), 100.0 - 2 * it) }
            val loops = (rings + apart).shuffled(random).map { turned(it, random.nextInt(2)) }
            val domain = Domain.of(*loops.toTypedArray())
            val expected = 2 * (0 until depth).sumOf { (100.0 - 2 * it) * (100.0 - 2 * it) * if (it % 2 == 0) 1 else -1 }
            assertEquals(expected, domain.area)
            assertEquals(2 * depth, domain.loopCount)
        }
    }

    @Test
    fun `a segment keeps its tag when its loop is turned`() {
        val clockwise = doubleArrayOf(0.0, 0.0, 0.0, 1.0, 2.0, 1.0, 2.0, 0.0)
        val domain = Domain.builder().outer(clockwise, listOf("left", "top", "right", "bottom")).build()
        for (s in 0 until domain.segmentCount) {
            val x = (domain.x(domain.segmentStart(s)) + domain.x(domain.segmentEnd(s))) / 2
            val y = (domain.y(domain.segmentStart(s)) + domain.y(domain.segmentEnd(s))) / 2
            val side = if (x == 0.0) "left" else if (x == 2.0) "right" else if (y == 0.0) "bottom" else "top"
            assertEquals(side, domain.tags[domain.segmentTag(s)])
        }
        assertArrayEquals(intArrayOf(0, 3, 2, 1), domain.loopNodes(0))
    }

    @Test
    fun `points at one place become one node`() {
        val domain = Domain.builder()
            .outer(square(0.0, 0.0, 4.0))
            .hole(doubleArrayOf(-0.0, 0.0, 1.0, 2.0, 2.0, 1.0))
            .hole(doubleArrayOf(1.0, 2.0, 2.0, 3.0, 1.0, 3.0))
            .embed(doubleArrayOf(2.0, 1.0, 3.0, 1.0, 4.0, 4.0), "line")
            .build()
        assertEquals(4 + 2 + 2 + 1, domain.nodeCount)
        assertEquals(3, domain.loopCount)
        assertEquals(4 + 3 + 3 + 2, domain.segmentCount)
        assertTrue(domain.isEmbedded(10) && domain.isEmbedded(11) && !domain.isEmbedded(9))
        assertEquals("line", domain.tags[domain.segmentTag(11)])
    }

    @Test
    fun `a hole whose nodes all lie on the outer loop is inside it`() {
        val domain = Domain.of(
            doubleArrayOf(0.0, 0.0, 2.0, 0.0, 4.0, 0.0, 4.0, 2.0, 4.0, 4.0, 2.0, 4.0, 0.0, 4.0, 0.0, 2.0),
            doubleArrayOf(2.0, 0.0, 4.0, 2.0, 2.0, 4.0, 0.0, 2.0),
        )
        assertEquals(8.0, domain.area)
    }

    @Test
    fun `a loop that passes through a node twice is split there`() {
        val eight = doubleArrayOf(0.0, 0.0, 2.0, 0.0, 2.0, 1.0, 1.0, 1.0, 2.0, 2.0, 0.0, 2.0, 1.0, 1.0, 0.0, 1.0)
        val domain = Domain.builder().outer(eight).build()
        assertEquals(2, domain.loopCount)
        assertEquals(7, domain.nodeCount)
    }

    @Test
    fun `coordinates come back bit for bit`() {
        val random = Random(7)
        val finite = generateSequence { Double.fromBits(random.nextLong()) }.filter { it.isFinite() }
        val loop = finite.take(200).toList().toDoubleArray()
        val domain = Domain.builder().outer(loop).build()
        val expected = loop.map { it.toRawBits() }.toSet()
        assertEquals(expected, domain.nodeCoordinates().map { it.toRawBits() }.toSet())
    }

    @Test
    fun `malformed arrays are refused`() {
        assertThrows(IllegalArgumentException::class.java) { Domain.builder().outer(doubleArrayOf(1.0, 2.0, 3.0)) }
        assertThrows(IllegalArgumentException::class.java) { Domain.builder().hole(DoubleArray(0)) }
        assertThrows(IllegalArgumentException::class.java) { Domain.builder().embed(doubleArrayOf(1.0, 2.0), "line") }
        assertThrows(IllegalArgumentException::class.java) { Domain.builder().outer(square(0.0, 0.0, 1.0), listOf("a")) }
    }

    @Test
    fun `ten thousand holes are sorted out in time`() {
        val builder = Domain.builder()
        for (i in 0 until 10_000) builder.loop(square(1.0 + 2 * (i % 100), 1.0 + 2 * (i / 100), 1.0))
        val domain = builder.loop(square(0.0, 0.0, 201.0)).build()
        assertEquals(201.0 * 201.0 - 10_000, domain.area)
        assertFalse(domain.isHole(10_000))
    }

    private fun turned(xy: DoubleArray, flag: Int): DoubleArray =
        if (flag == 0) xy else DoubleArray(xy.size) { xy[(xy.size - 2 - (it - it % 2)) + it % 2] }

    private fun square(x: Double, y: Double, side: Double) =
        doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)
}
