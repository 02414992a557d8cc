package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.Checkpoint
import org.trigrid.reliability.RandomLoops
import java.util.Random

class DomainFrameTest {
    private val unheard = Checkpoint.unheard()
    private val rectangle = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 3.0, 0.0, 3.0, 1.0, 3.0, 2.0, 2.0, 2.0, 0.0, 2.0)

    @Test
    fun `an outline turned and moved is the same to the bit in its frame`() {
        val outlines = listOf(RandomLoops.star(Random(5), 40, 0.4, 1), rectangle, polygon(6, 1.0, 0.1), polygon(7, 1.0, 0.0))
        for (outline in outlines) for (angle in listOf(0.4, 1.0, Math.PI / 4, Math.PI / 2, 2.5, 4.0)) {
            assertEquals(places(Domain.of(outline)), places(Domain.of(moved(outline, angle))), "turned by $angle")
        }
    }

    @Test
    fun `rings whose moments vanish have a frame by the order of their nodes`() {
        for ((outer, inner) in listOf(65 to 41, 12 to 9, 100 to 7, 16 to 5)) for (angle in listOf(0.5, 1.0, 3.0)) {
            val ring = arrayOf(polygon(outer, 1.0, 0.0), polygon(inner, 0.4, 0.13).reversedLoop())
            val turned = Array(2) { moved(ring[it], angle) }
            val mirrored = Array(2) { k -> turned[k].reversedLoop().also { for (i in it.indices step 2) it[i] = -it[i] } }
            assertEquals(places(Domain.of(*ring)), places(Domain.of(*turned)), "$outer and $inner, turned by $angle")
            assertEquals(places(Domain.of(*ring)), places(Domain.of(*mirrored)), "$outer and $inner, mirrored")
        }
    }

    @Test
    fun `what is drawn along the axes stays along them`() {
        val domain = Domain.of(rectangle)
        val laid = LaidDomain.inFrame(domain, DomainFrame(domain, unheard).frames().first(), unheard).domain
        for (s in 0 until laid.segmentCount) {
            val (a, b) = laid.segmentStart(s) to laid.segmentEnd(s)
            assertTrue(laid.x(a) == laid.x(b) || laid.y(a) == laid.y(b))
        }
    }

    @Test
    fun `places go back to where they were, to within the grid`() {
        val domain = Domain.of(RandomLoops.star(Random(7), 30, 0.4, 1))
        for (frame in DomainFrame(domain, unheard).frames()) {
            val pose = LaidDomain.inFrame(domain, frame, unheard).pose
            for (node in 0 until domain.nodeCount) {
                val x = pose.x(domain.x(node), domain.y(node))
                val y = pose.y(domain.x(node), domain.y(node))
                assertEquals(domain.x(node), pose.givenX(x, y), frame.step)
                assertEquals(domain.y(node), pose.givenY(x, y), frame.step)
            }
        }
    }

    @Test
    fun `no grid is as coarse as a segment, or as fine as the rounding of far places`() {
        val tiny = Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1e-10, 1.0, 0.0, 1.0))
        assertEquals(1, DomainFrame(tiny, unheard).frames().size)
        assertTrue(DomainFrame(Domain.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1e-13, 1.0, 0.0, 1.0)), unheard).frames().isEmpty())
        val far = Domain.of(DoubleArray(rectangle.size) { rectangle[it] + 1e9 })
        assertTrue(DomainFrame(far, unheard).frames().all { it.step >= 16 * Math.ulp(1e9) })
    }

    /** Nodes and where their segments run, as the frame has them. */
    private fun places(domain: Domain): List<List<Double>> {
        val laid = LaidDomain.inFrame(domain, DomainFrame(domain, unheard).frames().first(), unheard).domain
        return (0 until laid.segmentCount).map {
            val (a, b) = laid.segmentStart(it) to laid.segmentEnd(it)
            listOf(laid.x(a), laid.y(a), laid.x(b), laid.y(b))
        }.sortedWith(compareBy({ it[0] }, { it[1] }, { it[2] }, { it[3] }))
    }

    private fun polygon(n: Int, radius: Double, from: Double) = DoubleArray(2 * n) {
        val angle = from + 2 * Math.PI * (it / 2) / n
        radius * if (it % 2 == 0) StrictMath.cos(angle) else StrictMath.sin(angle)
    }

    private fun DoubleArray.reversedLoop() = DoubleArray(size) { this[size - 2 - it + 2 * (it % 2)] }

    private fun moved(loop: DoubleArray, angle: Double) = DoubleArray(loop.size) {
        val x = loop[it - it % 2]
        val y = loop[it - it % 2 + 1]
        if (it % 2 == 0) 0.7 + StrictMath.cos(angle) * x - StrictMath.sin(angle) * y else StrictMath.sin(angle) * x + StrictMath.cos(angle) * y
    }
}
