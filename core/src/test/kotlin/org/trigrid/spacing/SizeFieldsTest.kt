package org.trigrid.spacing

import kotlin.math.hypot
import kotlin.math.sqrt
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.trigrid.MeshOptions
import org.trigrid.diagnostics.InvalidSizeException
import org.trigrid.domain.Domain
import org.trigrid.geometry.HalfEdges
import org.trigrid.geometry.Pose

class SizeFieldsTest {
    private val gradation = 0.25

    @Test
    fun `node sizes are the mean of the segments that end there`() {
        val sizes = SizeFields.nodeSizes(SpacingDomains.of(doubleArrayOf(0.0, 0.0, 3.0, 0.0, 3.0, 4.0)))
        assertEquals(listOf(4.0, 3.5, 4.5), sizes.toList())
    }

    @Test
    fun `GRADE is the lower envelope of the boundary's cones`() {
        repeat(40) { seed ->
            val random = Random(seed)
            val domain = SpacingDomains.of(SpacingDomains.star(random, 15 + random.nextInt(300), random.nextDouble()))
            val field = field(domain) { sizes(Sizes.GRADE) }
            repeat(200) {
                val x = 2.4 * random.nextDouble() - 1.2
                val y = 2.4 * random.nextDouble() - 1.2
                val exact = envelope(domain, x, y)
                val hint = if (it % 3 == 0) -1 else if (it % 3 == 1) field.lastHint else field.hintOf(random.nextInt(domain.nodeCount))
                val size = field.sizeAt(x, y, hint)
                assertTrue(size >= exact * (1 - 1e-12) && size <= exact * (1 + 1.01 * GradedField.TOLERANCE)) { "$size for $exact" }
            }
        }
    }

    private fun envelope(domain: Domain, x: Double, y: Double): Double {
        val sizes = SizeFields.nodeSizes(domain)
        return sizes.indices.minOf { sizes[it] + gradation * hypot(domain.x(it) - x, domain.y(it) - y) }
    }

    @Test
    fun `cones of equal places, no sources and negative sizes`() {
        assertEquals(7.0, ConeTree(DoubleArray(0), DoubleArray(0), 1.0).min(0.0, 0.0, -1, 7.0))
        val xy = DoubleArray(200) { 0.5 }
        val cones = ConeTree(xy, DoubleArray(100) { -1.0 - it }, 2.0)
        assertEquals(-100.0 + 2.0 * sqrt(0.5), cones.min(0.0, 0.0, 3, Double.POSITIVE_INFINITY), 1e-12)
        assertEquals(99, cones.winner)
    }

    @Test
    fun `SMOOTH is linear between the nodes of a triangle`() {
        // A square with 4 segments a side round a hole of finer ones: spacing changes gently, no limit interferes.
        val domain = SpacingDomains.of(SpacingDomains.square(10, 1.0), SpacingDomains.circle(0.5, 0.5, 0.2, 24, clockwise = true))
        val field = field(domain) {}
        val mesh = ConstrainedDelaunay.of(domain)
        val sizes = SizeFields.nodeSizes(domain)
        for (t in 0 until mesh.triangleCount) {
            val (a, b, c) = (0..2).map { mesh.nodes[3 * t + it] }
            val x = 0.5 * domain.x(a) + 0.3 * domain.x(b) + 0.2 * domain.x(c)
            val y = 0.5 * domain.y(a) + 0.3 * domain.y(b) + 0.2 * domain.y(c)
            assertEquals(0.5 * sizes[a] + 0.3 * sizes[b] + 0.2 * sizes[c], field.sizeAt(x, y, field.hintOf(a)), 1e-9)
        }
        for (node in 0 until domain.nodeCount) {
            assertEquals(sizes[node], field.sizeAt(domain.x(node), domain.y(node), field.hintOf(node)), 1e-12)
        }
    }

    @Test
    fun `SMOOTH keeps the gradation at nodes and never exceeds the spacing`() {
        repeat(40) { seed ->
            val random = Random(seed)
            val domain = SpacingDomains.of(SpacingDomains.star(random, 15 + random.nextInt(100), random.nextDouble()))
            val field = field(domain) {}
            val sizes = DoubleArray(domain.nodeCount) { field.sizeAt(domain.x(it), domain.y(it), field.hintOf(it)) }
            for (i in sizes.indices) {
                assertEquals(envelope(domain, domain.x(i), domain.y(i)), sizes[i], 1e-9)
                for (j in 0 until i) {
                    val distance = hypot(domain.x(i) - domain.x(j), domain.y(i) - domain.y(j))
                    assertTrue(Math.abs(sizes[i] - sizes[j]) <= gradation * distance + 1e-9)
                }
            }
        }
    }

    @Test
    fun `walks end, from any hint and outside of the domain too`() {
        val domain = SpacingDomains.comb(50, 0.02, 0.3)
        val field = field(domain) {}
        val random = Random(1)
        repeat(20_000) {
            val size = field.sizeAt(6 * random.nextDouble() - 2, 4 * random.nextDouble() - 1, field.hintOf(random.nextInt(domain.nodeCount)))
            assertTrue(size > 0 && size < 10)
        }
    }

    @Test
    fun `a place seen from the middle of the first triangle is found`() {
        for (domain in listOf(SpacingDomains.comb(30, 0.05, 0.5), SpacingDomains.of(SpacingDomains.star(Random(2), 100, 0.9)))) {
            val mesh = ConstrainedDelaunay.of(domain)
            val walk = TriangleWalk(mesh)
            for (t in 0 until mesh.triangleCount) {
                for (e in 3 * t..3 * t + 2) {
                    if (mesh.twins[e] < 0) continue
                    val end = HalfEdges.next(e)
                    val x = 0.5 * (domain.x(mesh.nodes[e]) + domain.x(mesh.nodes[end]))
                    val y = 0.5 * (domain.y(mesh.nodes[e]) + domain.y(mesh.nodes[end]))
                    val middleX = (0..2).sumOf { domain.x(mesh.nodes[3 * t + it]) } / 3
                    val middleY = (0..2).sumOf { domain.y(mesh.nodes[3 * t + it]) } / 3
                    val found = walk.find(x + 1e-6 * (x - middleX), y + 1e-6 * (y - middleY), t)
                    assertTrue(walk.reached)
                    assertEquals(mesh.twins[e] / 3, found)
                }
            }
        }
    }

    @Test
    fun `bounds hold, and a coarse side falls to the ceiling by the gradation`() {
        val domain = SpacingDomains.of(SpacingDomains.square(10, 1.0))
        for (rule in Sizes.entries) {
            val field = field(domain) { sizes(rule).maxSize(0.02).minSize(0.01) }
            assertEquals(0.02, field.sizeAt(0.5, 0.5, field.hintOf(0)), 1e-12)
            assertEquals(0.1, field.sizeAt(0.5, 0.0, field.hintOf(0)), 1e-3)
            assertEquals(0.1 - gradation * 0.1, field.sizeAt(0.5, 0.1, field.hintOf(0)), 1e-3)
            val floor = field(domain) { sizes(rule).minSize(0.3) }
            assertEquals(0.3, floor.sizeAt(0.5, 0.01, floor.hintOf(3)))
        }
    }

    @Test
    fun `the user's sizes are followed, limited and called a bounded number of times`() {
        val domain = SpacingDomains.of(SpacingDomains.square(20, 1.0))
        var calls = 0
        val field = field(domain) {
            sizeFunction { x, y ->
                calls++
                0.001 + 0.2 * hypot(x - 0.3, y - 0.6)
            }
        }
        val callsBefore = calls
        assertTrue(callsBefore in 1000..SampledSizes.MAX_CALLS)
        val random = Random(5)
        var hint = field.hintOf(0)
        repeat(2000) {
            val x = 0.1 + 0.8 * random.nextDouble()
            val y = 0.1 + 0.8 * random.nextDouble()
            val wanted = Math.min(0.05, 0.001 + 0.2 * hypot(x - 0.3, y - 0.6))
            assertEquals(1.0, field.sizeAt(x, y, hint) / wanted, 0.12)
            hint = field.lastHint
        }
        assertEquals(callsBefore, calls)
    }

    @Test
    fun `a jump of the user's sizes becomes a slope`() {
        val domain = SpacingDomains.of(SpacingDomains.square(20, 1.0))
        val field = field(domain) { sizeFunction { x, _ -> if (x < 0.5) 0.005 else Double.POSITIVE_INFINITY } }
        assertEquals(0.005, field.sizeAt(0.4, 0.5, field.hintOf(0)), 1e-6)
        assertEquals(0.005 + gradation * 0.1, field.sizeAt(0.6, 0.5, field.hintOf(0)), 0.003)
        assertEquals(0.05, field.sizeAt(0.8, 0.5, field.hintOf(0)), 1e-3)
    }

    @Test
    fun `sizes that are none are refused inside of the domain only`() {
        val domain = SpacingDomains.of(SpacingDomains.circle(0.0, 0.0, 1.0, 40))
        val thrown = assertThrows(InvalidSizeException::class.java) {
            field(domain) { sizeFunction { x, y -> if (x > 0.2 && y > 0.2) Double.NaN else 0.1 } }
        }
        assertTrue(thrown.x > 0.2 && thrown.y > 0.2 && hypot(thrown.x, thrown.y) <= 1)
        val field = field(domain) { sizeFunction { x, y -> if (hypot(x, y) > 1) -1.0 else 0.1 } }
        assertEquals(0.1, field.sizeAt(0.0, 0.0, field.hintOf(0)), 1e-3)
    }

    @Test
    fun `estimates count elements`() {
        val uniform = SpacingDomains.of(SpacingDomains.square(100, 1.0))
        for (rule in Sizes.entries) {
            val field = field(uniform) { sizes(rule).gradation(1e-6) }
            assertEquals(4 / sqrt(3.0) * 1e4, SizeFields.estimateElements(ConstrainedDelaunay.of(uniform), field), 50.0)
        }
        val random = Random(3)
        repeat(10) {
            val domain = SpacingDomains.of(
                SpacingDomains.circle(0.0, 0.0, 1.0, 40 + random.nextInt(100)),
                SpacingDomains.circle(0.3, 0.1, 0.01, 20, clockwise = true),
            )
            for (rule in Sizes.entries) {
                val field = field(domain) { sizes(rule) }
                val estimate = SizeFields.estimateElements(ConstrainedDelaunay.of(domain), field)
                assertEquals(1.0, estimate / sampled(domain, field), 0.05)
            }
        }
    }

    /** The integral by polar midpoints about the small hole. */
    private fun sampled(domain: Domain, field: SizeField): Double {
        val locator = InsideLocator(domain)
        var sum = 0.0
        for (ring in 0 until 400) {
            val inner = 0.0095 * Math.pow(140.0, ring / 400.0)
            val outer = 0.0095 * Math.pow(140.0, (ring + 1) / 400.0)
            val area = Math.PI * (outer * outer - inner * inner) / 120
            for (k in 0 until 120) {
                val angle = 2 * Math.PI * (k + 0.5) / 120
                val x = 0.3 + 0.5 * (inner + outer) * Math.cos(angle)
                val y = 0.1 + 0.5 * (inner + outer) * Math.sin(angle)
                if (!locator.isInside(x, y)) continue
                val size = field.sizeAt(x, y, field.lastHint)
                sum += 4 / sqrt(3.0) * area / (size * size)
            }
        }
        return sum
    }

    private fun field(domain: Domain, configure: MeshOptions.Builder.() -> Unit): SizeField =
        SizeFields.create(domain, MeshOptions.builder().gradation(gradation).apply(configure).build().sizeRules(Pose.AS_GIVEN), ConstrainedDelaunay.of(domain))
}
