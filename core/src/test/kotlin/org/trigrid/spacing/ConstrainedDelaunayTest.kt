package org.trigrid.spacing

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import org.trigrid.diagnostics.InvalidDomainException
import org.trigrid.domain.Domain
import org.trigrid.geometry.HalfEdges
import org.trigrid.geometry.Predicates

class ConstrainedDelaunayTest {
    @Test
    fun `triangulates random star domains with and without holes`() {
        repeat(400) { seed ->
            val random = Random(seed)
            val outer = SpacingDomains.star(random, 15 + random.nextInt(120), random.nextDouble())
            val domain = if (seed % 2 == 0) {
                SpacingDomains.of(outer)
            } else {
                val count = 3 + random.nextInt(40)
                SpacingDomains.of(outer, SpacingDomains.circle(0.0, 0.0, 0.01, count, clockwise = true))
            }
            assertValid(domain)
        }
    }

    @Test
    fun `long segments across dense nodes are recovered`() {
        repeat(100) { seed ->
            val random = Random(seed)
            val n = 20 + random.nextInt(200)
            val upper = (0 until n).flatMap { listOf(1 - (it + random.nextDouble()) / n, 1e-3 * (1 + random.nextDouble())) }
            val lower = (0 until n).flatMap { listOf((it + random.nextDouble()) / n, -1e-3 * (1 + random.nextDouble())) }
            val above = doubleArrayOf(-1.0, 0.0, 2.0, 0.0) + upper.toDoubleArray()
            val below = doubleArrayOf(2.0, 0.0, -1.0, 0.0) + lower.toDoubleArray()
            assertValid(SpacingDomains.of(above))
            assertValid(SpacingDomains.of(below))
            val both = doubleArrayOf(-1.0, 0.0) + lower.toDoubleArray() + doubleArrayOf(2.0, 0.0) + upper.toDoubleArray()
            assertValid(SpacingDomains.withLines(listOf(both), listOf(doubleArrayOf(-1.0, 0.0, 2.0, 0.0))))
        }
    }

    @Test
    fun `hostile shapes are triangulated`() {
        val ulp = Math.nextUp(1.0)
        val shapes = listOf(
            SpacingDomains.lattice(21, 31),
            SpacingDomains.comb(60, 0.01, 0.5),
            SpacingDomains.comb(40, 1e-6, 0.7),
            SpacingDomains.gradedSquare(1e-7, 1.3),
            SpacingDomains.of(SpacingDomains.square(200)),
            SpacingDomains.of(SpacingDomains.circle(0.0, 0.0, 1.0, 3000)),
            SpacingDomains.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, ulp, 0.0, 1.0, 1.0, 1.0, ulp, 0.0, 1.0)),
            SpacingDomains.of(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1e-9)),
            SpacingDomains.of(doubleArrayOf(0.0, 0.0, 0.1, 0.1, 0.2, 0.2, 0.3, 0.3, 0.9, 0.9, 0.0, 1.0)),
            rotatedSquare(),
            spiral(600),
        )
        for (shape in shapes) {
            assertValid(shape)
            assertValid(SpacingDomains.moved(shape, 1e-9, 0.0, 0.0))
            assertValid(SpacingDomains.moved(shape, 1e9, 0.0, 0.0))
        }
        assertValid(SpacingDomains.moved(SpacingDomains.lattice(21, 31), 0.1, 1e7, -1e7))
        assertValid(SpacingDomains.moved(SpacingDomains.comb(60, 0.01, 0.5), 1.0, 1e7, 1e7))
        assertValid(SpacingDomains.moved(spiral(600), 1.0, 1e7, 1e7))
    }

    private fun rotatedSquare(): Domain {
        val loop = SpacingDomains.square(100)
        for (i in 0 until loop.size / 2) {
            val x = loop[2 * i]
            loop[2 * i] = 0.8 * x - 0.6 * loop[2 * i + 1]
            loop[2 * i + 1] = 0.6 * x + 0.8 * loop[2 * i + 1]
        }
        return SpacingDomains.of(loop)
    }

    private fun spiral(count: Int): Domain {
        val out = (0 until count).flatMap { i ->
            val angle = 12 * PI * i / count
            listOf((1 + angle) * cos(angle), (1 + angle) * sin(angle))
        }
        val back = (count - 1 downTo 0).flatMap { i ->
            val angle = 12 * PI * i / count
            listOf((1.4 + angle) * cos(angle), (1.4 + angle) * sin(angle))
        }
        return SpacingDomains.of((out + back).toDoubleArray().reversedPairs())
    }

    private fun DoubleArray.reversedPairs() = DoubleArray(size) { this[size - 2 - 2 * (it / 2) + it % 2] }

    @Test
    fun `islands, several components and touching loops`() {
        val island = SpacingDomains.of(
            SpacingDomains.square(8, 10.0),
            SpacingDomains.circle(5.0, 5.0, 3.0, 40, clockwise = true),
            SpacingDomains.circle(5.0, 5.0, 1.0, 20),
            SpacingDomains.circle(20.0, 5.0, 3.0, 30),
        )
        assertValid(island)
        // Two triangles and a hole that meet in the node (1, 0).
        assertValid(
            SpacingDomains.of(
                doubleArrayOf(0.0, -1.0, 1.0, 0.0, 0.0, 1.0),
                doubleArrayOf(1.0, 0.0, 4.0, -2.0, 4.0, 2.0),
                doubleArrayOf(1.0, 0.0, 2.0, 0.3, 2.0, -0.3),
            ),
        )
    }

    @Test
    fun `embedded segments have triangles on both sides`() {
        val domain = SpacingDomains.withLines(
            listOf(SpacingDomains.square(3)),
            listOf(doubleArrayOf(0.0, 0.0, 0.5, 0.51, 0.9, 0.9), doubleArrayOf(0.1, 0.9, 0.4, 0.8)),
        )
        assertValid(domain)
        val mesh = ConstrainedDelaunay.of(domain)
        assertEquals(2 * 3 + 12, mesh.nodes.indices.count { mesh.isSegment(it) })
    }

    @Test
    fun `refuses what only a faulty domain holds, and says where`() {
        assertEquals(FaultKind.CROSSING, faultOf(doubleArrayOf(0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.5)))
        assertEquals(FaultKind.TOUCHING, faultOf(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 1.0, 0.0, 0.0, 2.0)))
        assertEquals(FaultKind.DEGENERATE_LOOP, faultOf(doubleArrayOf(0.0, 0.0, 2.0, 0.0, 1.0, 0.0)))
        val xy = doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0)
        val twice = Domain(xy, intArrayOf(0, 1, 1, 2, 2, 3), IntArray(3), BooleanArray(3), listOf("b"), "domain")
        val thrown = assertThrows(InvalidDomainException::class.java) { ConstrainedDelaunay.of(twice) }
        assertEquals(listOf(0, 3), thrown.faults.single().nodes().toList())
    }

    private fun faultOf(loop: DoubleArray): FaultKind =
        assertThrows(InvalidDomainException::class.java) { ConstrainedDelaunay.of(SpacingDomains.of(loop)) }.faults.single().kind

    private fun assertValid(domain: Domain) {
        val mesh = ConstrainedDelaunay.of(domain)
        assertTopology(mesh)
        assertSegments(domain, mesh)
        assertEquals(eulerCount(domain), mesh.triangleCount)
        val area = areaInside(domain)
        var sum = 0.0
        for (t in 0 until mesh.triangleCount) sum += area(mesh, t)
        val extent = domain.xy.maxOf { kotlin.math.abs(it) }
        assertEquals(area, sum, 1e-9 * area + 1e-13 * extent * extent)
    }

    private fun assertTopology(mesh: ConstrainedDelaunay) {
        val xy = mesh.xy
        for (e in mesh.nodes.indices) {
            val a = mesh.nodes[e]
            val b = mesh.nodes[HalfEdges.next(e)]
            val c = mesh.nodes[HalfEdges.previous(e)]
            assertTrue(
                Predicates.orient(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]) > 0,
            )
            val f = mesh.twins[e]
            if (f < 0) continue
            assertEquals(e, mesh.twins[f])
            assertEquals(b, mesh.nodes[f])
            assertEquals(a, mesh.nodes[HalfEdges.next(f)])
            val d = mesh.nodes[HalfEdges.previous(f)]
            // Doubles may be able to prove it in one order of the nodes and not in the other.
            val seenFromLeft = inCircle(xy, a, b, c, d)
            val seenFromRight = inCircle(xy, b, a, d, c)
            assertTrue(mesh.isSegment(e) || Math.min(seenFromLeft, seenFromRight) <= 0) { "edge $a-$b of $c, $d: $seenFromLeft $seenFromRight of ${xy.size}" }
        }
        for (node in mesh.edgeOfNode.indices) assertEquals(node, mesh.nodes[mesh.edgeOfNode[node]])
    }

    private fun inCircle(xy: DoubleArray, a: Int, b: Int, c: Int, d: Int) = Predicates.inCircleFiltered(
        xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1], xy[2 * d], xy[2 * d + 1],
    )

    private fun assertSegments(domain: Domain, mesh: ConstrainedDelaunay) {
        val expected = HashSet<Pair<Int, Int>>()
        for (s in 0 until domain.segmentCount) {
            val pair = domain.segmentStart(s) to domain.segmentEnd(s)
            expected += pair
            if (domain.isEmbedded(s)) expected += pair.second to pair.first
        }
        val found = HashSet<Pair<Int, Int>>()
        for (e in mesh.nodes.indices) {
            if (mesh.isSegment(e)) found += mesh.nodes[e] to mesh.nodes[HalfEdges.next(e)]
        }
        assertEquals(expected, found)
    }

    /** Triangles by angle count: each node's inner angle sums to pi per triangle; from Euler's formula per sector. */
    private fun eulerCount(domain: Domain): Int {
        val boundary = (0 until domain.segmentCount).filter { !domain.isEmbedded(it) }
        val leaving = IntArray(domain.nodeCount)
        boundary.forEach { leaving[domain.segmentStart(it)]++ }
        val inner = leaving.count { it == 0 }
        var turning = 0.0
        for (sector in sectors(domain, boundary)) turning += sector
        return Math.round((turning + 2 * PI * inner) / PI).toInt()
    }

    /** Inner angle at each place where the boundary comes to a node and leaves it, by sorting the directions. */
    private fun sectors(domain: Domain, boundary: List<Int>): List<Double> {
        val angles = ArrayList<Double>()
        val byNode = HashMap<Int, MutableList<Pair<Double, Boolean>>>()
        for (s in boundary) {
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            val direction = kotlin.math.atan2(domain.y(b) - domain.y(a), domain.x(b) - domain.x(a))
            val back = kotlin.math.atan2(domain.y(a) - domain.y(b), domain.x(a) - domain.x(b))
            byNode.getOrPut(a) { ArrayList() } += direction to true
            byNode.getOrPut(b) { ArrayList() } += back to false
        }
        for (ends in byNode.values) {
            ends.sortBy { it.first }
            for (i in ends.indices) {
                if (!ends[i].second) continue
                val next = ends[(i + 1) % ends.size]
                assertTrue(!next.second)
                val angle = next.first - ends[i].first
                angles += if (angle < 0) angle + 2 * PI else angle
            }
        }
        return angles
    }

    private fun areaInside(domain: Domain): Double {
        var sum = 0.0
        for (s in 0 until domain.segmentCount) {
            if (domain.isEmbedded(s)) continue
            val a = domain.segmentStart(s)
            val b = domain.segmentEnd(s)
            val x = domain.x(0)
            val y = domain.y(0)
            sum += 0.5 * ((domain.x(a) - x) * (domain.y(b) - y) - (domain.y(a) - y) * (domain.x(b) - x))
        }
        return sum
    }

    private fun area(mesh: ConstrainedDelaunay, t: Int): Double {
        val (a, b, c) = (0..2).map { mesh.nodes[3 * t + it] }
        val x = mesh.xy[2 * a]
        val y = mesh.xy[2 * a + 1]
        return 0.5 * ((mesh.xy[2 * b] - x) * (mesh.xy[2 * c + 1] - y) - (mesh.xy[2 * b + 1] - y) * (mesh.xy[2 * c] - x))
    }
}
