package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.random.Random

class DomainWalksTest {
    /** Nodes 0-3: a square; 4-6: a triangle in it; 7: half way between 0 and 4. */
    private val xy = doubleArrayOf(0.0, 0.0, 8.0, 0.0, 8.0, 8.0, 0.0, 8.0, 2.0, 2.0, 3.0, 4.0, 4.0, 2.0, 1.0, 1.0)
    private val keyhole = intArrayOf(0, 7, 4, 5, 6, 4, 7, 0, 1, 2, 3)

    @Test
    fun `a connector falls away and its own node with it`() {
        val domain = domain(keyhole)
        assertEquals(7, domain.nodeCount)
        assertEquals(7, domain.segmentCount)
        assertArrayEquals(intArrayOf(4, 5, 6), domain.loopNodes(0))
        assertArrayEquals(intArrayOf(0, 1, 2, 3), domain.loopNodes(1))
        assertEquals(62.0, domain.area)
        assertTrue(domain.isHole(0))
    }

    @Test
    fun `a connector is kept as one embedded line when asked`() {
        val domain = domain(keyhole, keepConnectors = true)
        assertEquals(8, domain.nodeCount)
        assertEquals(9, domain.segmentCount)
        assertEquals(listOf(7, 8), (0 until 9).filter { domain.isEmbedded(it) })
        assertArrayEquals(intArrayOf(0, 7, 7, 4), IntArray(4) { domain.segments[14 + it] })
        assertEquals(62.0, domain.area)
    }

    @Test
    fun `a clockwise walk is turned as a whole`() {
        val domain = domain(keyhole.reversedArray())
        assertEquals(62.0, domain.area)
        assertEquals(2, domain.loopCount)
    }

    @Test
    fun `tags stay with their steps in either direction`() {
        for (walk in listOf(keyhole, keyhole.reversedArray())) {
            val tags = IntArray(walk.size) { Math.max(walk[it], walk[(it + 1) % walk.size]) }
            val domain = Domain.fromWalks(xy, listOf(walk), listOf(tags), (0..7).map { "t$it" }, "r", false)
            for (s in 0 until domain.segmentCount) {
                val higher = Math.max(domain.segmentStart(s), domain.segmentEnd(s))
                assertEquals("t$higher", domain.tags[domain.segmentTag(s)])
            }
        }
    }

    @Test
    fun `included shapes on a connector outside are a second component`() {
        val nodes = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 5.0, 0.0, 6.0, 0.0, 5.0, 1.0)
        val walk = intArrayOf(0, 1, 3, 4, 5, 3, 1, 2)
        val domain = Domain.fromWalks(nodes, listOf(walk), listOf(IntArray(8)), listOf("b"), "r", false)
        assertEquals(2, domain.loopCount)
        assertEquals(1.0, domain.area)
        assertFalse(domain.isHole(0) || domain.isHole(1))
    }

    @Test
    fun `two walks side by side become one component`() {
        val nodes = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 1.0)
        val walks = listOf(intArrayOf(0, 1, 4, 5), intArrayOf(1, 2, 3, 4))
        val tags = listOf(IntArray(4), IntArray(4))
        val joined = Domain.fromWalks(nodes, walks, tags, listOf("b"), "r", false)
        assertEquals(1, joined.loopCount)
        assertArrayEquals(intArrayOf(0, 1, 2, 3, 4, 5), joined.loopNodes(0))
        val kept = Domain.fromWalks(nodes, walks, tags, listOf("b"), "r", true)
        assertEquals(1, (0 until kept.segmentCount).count { kept.isEmbedded(it) })
    }

    @Test
    fun `a dead end stays to be reported, unless connectors are kept`() {
        val walk = intArrayOf(0, 7, 4, 7, 0, 1, 2, 3)
        assertEquals(8, domain(walk).segmentCount)
        assertEquals(4 + 2, domain(walk, keepConnectors = true).segmentCount)
    }

    @Test
    fun `walks through connectors give the domain of their loops`() {
        val random = Random(5)
        repeat(200) {
            val walk = KeyholeWalk(random)
            val expected = Domain.of(*walk.rings.toTypedArray())
            val dropped = walk.domain(random, keepConnectors = false)
            assertEquals(emptyList<Any>(), DomainCheck.check(dropped))
            assertEquals(expected.area, dropped.area, 1e-12)
            assertEquals(expected.loopCount, dropped.loopCount)
            assertEquals(segments(expected), segments(dropped))
            assertEquals(expected.nodeCount, dropped.nodeCount)
            val kept = walk.domain(random, keepConnectors = true)
            assertEquals(expected.segmentCount + walk.connectorSteps, kept.segmentCount)
        }
    }

    private fun segments(domain: Domain) = (0 until domain.segmentCount).map { s ->
        listOf(domain.segmentStart(s), domain.segmentEnd(s)).flatMap { listOf(domain.x(it), domain.y(it)) }
    }.toSet()

    /** A square ring with small square openings on connectors of one or two steps, each from a node of the ring. */
    private class KeyholeWalk(random: Random) {
        val rings = ArrayList<DoubleArray>()
        var connectorSteps = 0
        private val xy = ArrayList<Double>()
        private val walk = ArrayList<Int>()

        init {
            val n = 4 * (1 + random.nextInt(5))
            rings.add(DoubleArray(2 * n) { perimeter(it / 2, n)[it % 2] })
            xy.addAll(rings[0].toList())
            for (node in 0 until n) {
                walk.add(node)
                if (random.nextInt(3) > 0) addHole(random, node, n)
            }
        }

        private fun perimeter(i: Int, n: Int): DoubleArray {
            val part = (i % (n / 4)) * 40.0 / n
            return when (i / (n / 4)) {
                0 -> doubleArrayOf(part, 0.0)
                1 -> doubleArrayOf(10.0, part)
                2 -> doubleArrayOf(10 - part, 10.0)
                else -> doubleArrayOf(0.0, 10 - part)
            }
        }

        /** At 0.6 of the way from the middle, and so small that it meets no other. */
        private fun addHole(random: Random, node: Int, n: Int) {
            val (px, py) = perimeter(node, n).toList()
            val x = 5 + 0.6 * (px - 5)
            val y = 5 + 0.6 * (py - 5)
            val first = xy.size / 2
            val hole = doubleArrayOf(x, y, x + 0.1, y, x + 0.1, y + 0.1, x, y + 0.1)
            xy.addAll(hole.toList())
            rings.add(hole)
            val between = if (random.nextBoolean()) listOf(first + 4) else emptyList()
            for (i in between) xy.addAll(listOf((x + px) / 2, (y + py) / 2))
            walk.addAll(between + listOf(first, first + 3, first + 2, first + 1, first) + between + node)
            connectorSteps += 1 + between.size
        }

        fun domain(random: Random, keepConnectors: Boolean): Domain {
            val shift = random.nextInt(walk.size)
            val shifted = (walk.drop(shift) + walk.take(shift)).toIntArray()
            if (random.nextBoolean()) shifted.reverse()
            val tags = listOf(IntArray(shifted.size))
            return Domain.fromWalks(xy.toDoubleArray(), listOf(shifted), tags, listOf("b"), "r", keepConnectors)
        }
    }

    private fun domain(walk: IntArray, keepConnectors: Boolean = false): Domain =
        Domain.fromWalks(xy, listOf(walk), listOf(IntArray(walk.size)), listOf("b"), "r", keepConnectors)
}
