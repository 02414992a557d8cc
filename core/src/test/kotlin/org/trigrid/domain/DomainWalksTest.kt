package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

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

    private fun domain(walk: IntArray, keepConnectors: Boolean = false): Domain =
        Domain.fromWalks(xy, listOf(walk), listOf(IntArray(walk.size)), listOf("b"), "r", keepConnectors)
}
