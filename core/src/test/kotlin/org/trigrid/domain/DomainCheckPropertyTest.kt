package org.trigrid.domain

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.trigrid.diagnostics.FaultKind
import java.math.BigDecimal
import java.time.Duration
import kotlin.random.Random

class DomainCheckPropertyTest {
    @Test
    fun `stars with holes have no faults at any scale and offset`() {
        val random = Random(11)
        for (scale in listOf(1e-9, 1e-3, 1.0, 1e4, 1e9)) {
            repeat(20) { assertEquals(emptyList<Any>(), DomainCheck.check(star(random, scale, 0.0).build())) }
        }
        repeat(40) { assertEquals(emptyList<Any>(), DomainCheck.check(star(random, 1.0, 1e7).build())) }
    }

    @Test
    fun `each way of breaking a star is told`() {
        val random = Random(12)
        for ((scale, offset) in listOf(1.0 to 0.0, 1e-9 to 0.0, 1e9 to 0.0, 1.0 to 1e7)) {
            repeat(25) {
                for (kind in BREAKS.keys) {
                    val ring = starRing(random, 0.0, 0.0, 1.0, scale, offset)
                    val builder = Domain.builder().hole(starRing(random, 0.1, 0.1, 0.1, scale, offset))
                    BREAKS.getValue(kind)(builder, ring, random, scale)
                    val kinds = DomainCheck.check(builder.build()).map { it.kind }
                    assertTrue(kind in kinds) { "$kind missing in $kinds" }
                }
            }
        }
    }

    @Test
    fun `removing any segment is told as an open walk at its ends`() {
        val random = Random(13)
        repeat(50) {
            val whole = star(random, 1.0, 0.0).build()
            val gone = random.nextInt(whole.segmentCount)
            val kept = (0 until whole.segmentCount).filter { it != gone }
            val segments = IntArray(2 * kept.size) { whole.segments[2 * kept[it / 2] + it % 2] }
            val open = Domain(whole.xy, segments, IntArray(kept.size), BooleanArray(kept.size), listOf("b"), "r")
            val faults = DomainCheck.check(open)
            assertEquals(setOf(FaultKind.OPEN_WALK), faults.map { it.kind }.toSet())
            assertEquals(setOf(whole.segmentStart(gone), whole.segmentEnd(gone)), faults.map { it.nodes()[0] }.toSet())
        }
    }

    @Test
    fun `pairs agree with an exact test of all pairs`() {
        val random = Random(14)
        repeat(400) { round ->
            val size = 3 + random.nextInt(12)
            val lines = List(2 + random.nextInt(40)) { IntArray(4) { random.nextInt(size) } }.filter { it[0] != it[2] || it[1] != it[3] }
            val scale = Math.scalb(1.0, random.nextInt(-30, 31))
            val shift = if (round % 2 == 0) 0.0 else scale * (1 shl 23)
            val builder = Domain.builder().outer(square(-1.0, -1.0, size + 1.0).map { it * scale + shift }.toDoubleArray())
            for (line in lines) builder.embed(DoubleArray(4) { line[it] * scale + shift }, "line")
            val found = DomainCheck.check(builder.build()).groupingBy { it.kind }.eachCount()
            assertEquals(SoupFaults(lines).counts(), found)
        }
    }

    @Test
    fun `segment soups as boundary never fail the check itself`() {
        val random = Random(15)
        repeat(500) {
            val nodes = 2 + random.nextInt(12)
            val size = 1 + random.nextInt(5)
            val xy = DoubleArray(2 * nodes) { if (random.nextInt(60) == 0) Double.NaN else random.nextInt(size).toDouble() }
            val segments = IntArray(2 * (1 + random.nextInt(20))) { random.nextInt(nodes) }
            val count = segments.size / 2
            val boundary = random.nextInt(count + 1)
            val domain = Domain(xy, segments, IntArray(count), BooleanArray(count) { it >= boundary }, listOf("b"), "r")
            assertTrue(DomainCheck.check(domain).isNotEmpty() || boundary > 2)
            DomainCheck.warnings(domain)
        }
    }

    @Test
    fun `rectangles in a grid are faulty just where windings say so`() {
        val random = Random(16)
        var valid = 0
        repeat(4000) {
            val rectangles = List(1 + random.nextInt(4)) { GridRectangle(random) }
            val builder = Domain.builder()
            for (r in rectangles) if (r.isHole) builder.hole(r.xy()) else builder.outer(r.xy())
            val faults = DomainCheck.check(builder.build())
            val windings = (0 until 64).map { cell -> rectangles.sumOf { it.winding(cell % 8, cell / 8) } }
            val kinds = faults.map { it.kind }.toSet()
            val pairFaults = setOf(FaultKind.CROSSING, FaultKind.TOUCHING)
            if (kinds.any { it in pairFaults } || faults.any { "overlap at" in it.message || "run along" in it.message }) return@repeat
            assertEquals(windings.any { it !in 0..1 }, faults.isNotEmpty()) { "$rectangles $faults" }
            if (FaultKind.OVERLAP in kinds) assertTrue(windings.max() > 1) { "$rectangles $faults" }
            if (FaultKind.HOLE_OUTSIDE in kinds) assertTrue(windings.min() < 0) { "$rectangles $faults" }
            if (faults.isEmpty()) valid++
        }
        assertTrue(valid > 200) { "$valid" }
    }

    @Test
    fun `a node within an ulp of a segment is told by its exact side`() {
        val random = Random(17)
        val seen = HashSet<Int>()
        repeat(2000) {
            val b = doubleArrayOf(1 + random.nextDouble(), random.nextDouble())
            val share = random.nextInt(1, 16) / 16.0
            val p = doubleArrayOf(b[0] * share, Math.nextAfter(b[1] * share, b[1] * share + random.nextInt(-1, 2)))
            val domain = Domain.builder().outer(doubleArrayOf(0.0, 0.0, b[0], b[1], 0.0, 3.0))
                .hole(doubleArrayOf(p[0], p[1], 0.2, 1.5, 0.1, 1.5)).build()
            val side = (big(b[0]) * big(p[1])).compareTo(big(b[1]) * big(p[0]))
            val expected = if (side > 0) emptySet() else if (side == 0) setOf(FaultKind.TOUCHING) else setOf(FaultKind.CROSSING)
            assertEquals(expected, DomainCheck.check(domain).map { it.kind }.toSet())
            seen.add(side)
        }
        assertEquals(setOf(-1, 0, 1), seen)
    }

    @Test
    @Tag("corpus")
    fun `a million segments are checked within seconds`() {
        val n = 1_000_000
        val ring = DoubleArray(2 * n) {
            val angle = 2 * Math.PI * (it / 2) / n
            val radius = 1 + 0.3 * Math.sin(9 * angle) + 0.01 * Math.sin(1001 * angle)
            if (it % 2 == 0) radius * Math.cos(angle) else radius * Math.sin(angle)
        }
        val domain = Domain.of(ring)
        DomainCheck.check(Domain.of(ring.copyOf(200_000)))
        org.junit.jupiter.api.Assertions.assertTimeout(Duration.ofSeconds(8)) {
            assertEquals(emptyList<Any>(), DomainCheck.check(domain))
        }
    }

    private fun big(value: Double) = BigDecimal(value)

    private class GridRectangle(random: Random) {
        private val x0 = random.nextInt(7)
        private val y0 = random.nextInt(7)
        private val x1 = x0 + 1 + random.nextInt(8 - x0 - 1 + 1).coerceAtMost(7 - x0)
        private val y1 = y0 + 1 + random.nextInt(8 - y0 - 1 + 1).coerceAtMost(7 - y0)
        val isHole = random.nextInt(3) == 0

        fun winding(x: Int, y: Int) = if (x in x0 until x1 && y in y0 until y1) (if (isHole) -1 else 1) else 0

        fun xy() = intArrayOf(x0, y0, x1, y0, x1, y1, x0, y1).map { it.toDouble() }.toDoubleArray()

        override fun toString() = "[$x0 $y0 $x1 $y1 $isHole]"
    }

    private companion object {
        val BREAKS = mapOf<FaultKind, (DomainBuilder, DoubleArray, Random, Double) -> Unit>(
            FaultKind.NOT_A_NUMBER to { builder, ring, random, _ ->
                ring[random.nextInt(ring.size)] = listOf(Double.NaN, Double.POSITIVE_INFINITY)[random.nextInt(2)]
                builder.outer(ring)
            },
            FaultKind.ZERO_LENGTH to { builder, ring, random, _ ->
                val i = 2 * random.nextInt(ring.size / 2)
                builder.outer(ring.copyOfRange(0, i + 2) + ring.copyOfRange(i, ring.size))
            },
            FaultKind.SPIKE to { builder, ring, random, scale ->
                val i = 2 * random.nextInt(ring.size / 2)
                val tip = doubleArrayOf(ring[i] + 9 * scale, ring[i + 1] + 2 * scale)
                builder.outer(ring.copyOfRange(0, i + 2) + tip + ring.copyOfRange(i, ring.size))
            },
            FaultKind.CROSSING to { builder, ring, _, _ ->
                val half = ring.size / 4 * 2
                for (axis in 0..1) ring[axis] = ring[half + axis].also { ring[half + axis] = ring[axis] }
                builder.outer(ring)
            },
            FaultKind.OVERLAP to { builder, ring, _, _ ->
                builder.outer(ring).outer(ring)
            },
            FaultKind.HOLE_OUTSIDE to { builder, ring, _, scale ->
                builder.outer(ring).hole(DoubleArray(ring.size) { ring[it] + 5 * scale })
            },
            FaultKind.EMBEDDED_OUTSIDE to { builder, ring, _, scale ->
                builder.outer(ring).embed(doubleArrayOf(ring[0] + 5 * scale, ring[1], ring[0] + 5 * scale, ring[1] + scale), "line")
            },
            FaultKind.TOUCHING to { builder, ring, _, scale ->
                val x = ring[0] + 5 * scale
                val y = ring[1]
                builder.outer(ring).outer(doubleArrayOf(x, y, x + scale, y, x + scale, y + scale, x, y + scale))
                builder.hole(doubleArrayOf(x + scale, y + scale / 2, x + scale / 2, y + scale * 0.75, x + scale / 2, y + scale * 0.25))
            },
            FaultKind.DEGENERATE_LOOP to { builder, ring, _, _ ->
                builder.outer(ring).hole(doubleArrayOf(ring[0], ring[1] / 2, ring[0] / 2, ring[1]))
            },
        )

        fun square(x: Double, y: Double, side: Double) = doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)

        /** Up to nine holes, each in a cell of its own of a grid inside. */
        fun star(random: Random, scale: Double, offset: Double): DomainBuilder {
            val builder = Domain.builder().outer(starRing(random, 0.0, 0.0, 1.0, scale, offset))
            for (cell in 0 until 9) {
                if (random.nextBoolean()) builder.hole(starRing(random, (cell % 3 - 1) * 0.2, (cell / 3 - 1) * 0.2, 0.08, scale, offset))
            }
            return builder
        }

        /** Either direction; radii between half of [radius] and all of it. */
        fun starRing(random: Random, x: Double, y: Double, radius: Double, scale: Double, offset: Double): DoubleArray {
            val n = 5 + random.nextInt(60)
            val sign = if (random.nextBoolean()) 1 else -1
            return DoubleArray(2 * n).also {
                for (i in 0 until n) {
                    val angle = sign * 2 * Math.PI * (i + 0.8 * random.nextDouble()) / n
                    val r = radius * (0.5 + 0.5 * random.nextDouble())
                    it[2 * i] = (x + r * Math.cos(angle)) * scale + offset
                    it[2 * i + 1] = (y + r * Math.sin(angle)) * scale + offset
                }
            }
        }
    }
}
