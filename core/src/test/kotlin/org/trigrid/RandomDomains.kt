package org.trigrid

import org.trigrid.domain.Domain
import org.trigrid.reliability.HostileDomains
import org.trigrid.reliability.InnerDomains
import org.trigrid.reliability.LatticeDomains
import org.trigrid.reliability.MovedDomains
import org.trigrid.reliability.PathDomains
import org.trigrid.reliability.RandomLoops.placed
import org.trigrid.reliability.RandomLoops.star
import org.trigrid.reliability.RandomLoops.subdivided
import org.trigrid.reliability.RandomLoops.uneven
import java.util.Random

/**
 * Random and hostile domains, valid by construction but for what rounding may do to the most extreme; a seed gives the
 * same domain for ever. Families cover what breaks mesh generators: needles, thin gaps, spacing uneven over orders of
 * magnitude, many holes, touching loops, far offsets, tiny and huge scales.
 */
internal object RandomDomains {
    /** @param every only each so many-th seed is worth its time in a long run: the domains are large. */
    class Family(val name: String, val every: Int = 1, private val maker: (Random) -> Domain) {
        fun make(seed: Long): Domain = maker(Random(seed * 7919 + name.hashCode()))

        override fun toString(): String = name
    }

    /** Families of small domains, for the everyday tests. */
    val small: List<Family> by lazy { families.filter { it.every < 10 } }

    val families: List<Family> = (basic() + HostileDomains.families + LatticeDomains.families + PathDomains.families).let { all ->
        all + MovedDomains(all.filter { it.every < 10 }).families + InnerDomains(all.filter { it.every < 10 }).families
    }

    private fun basic() = listOf(
        Family("smooth star") { r -> built(star(r, 12 + r.nextInt(120), 0.15, 1), emptyList()) },
        Family("jagged star") { r -> built(star(r, 5 + r.nextInt(60), 0.9, 1), emptyList()) },
        Family("uneven spacing") { r -> built(uneven(r, star(r, 4 + r.nextInt(12), 0.6, 1), 4.0), emptyList()) },
        Family("star with holes") { r -> withHoles(r, star(r, 24 + r.nextInt(60), 0.1, 1), 1 + r.nextInt(6)) },
        Family("uneven with holes", every = 2) { r -> withHoles(r, uneven(r, star(r, 9 + r.nextInt(20), 0.1, 1), 2.5), 1 + r.nextInt(4)) },
        Family("needle") { r -> built(needle(r), emptyList()) },
        Family("thin gap") { r -> thinGap(r) },
        Family("comb") { r -> built(comb(r), emptyList()) },
        Family("spiral") { r -> built(spiral(r), emptyList()) },
        Family("size step") { r -> sizeStep(r) },
        Family("minimal") { r -> built(star(r, 3 + r.nextInt(2), 0.8, 1), emptyList()) },
        Family("touching holes") { r -> touchingHoles(r) },
        Family("island in hole") { r -> islandInHole(r) },
        Family("plate of holes", every = 8) { r -> plate(r) },
        Family("collinear runs", every = 2) { r -> built(uneven(r, polygonOnGrid(r), 6.0), emptyList()) },
        Family("far and scaled") { r -> built(moved(r, uneven(r, star(r, 6 + r.nextInt(30), 0.5, 1), 2.0)), emptyList()) },
        Family("embedded line") { r -> embeddedLine(r) },
        Family("neighbouring places") { r -> built(neighbouringPlaces(r), emptyList()) },
    )

    private fun built(outer: DoubleArray, holes: List<DoubleArray>): Domain {
        val builder = Domain.builder().outer(outer)
        holes.forEach { builder.hole(it) }
        return builder.build()
    }

    private fun withHoles(r: Random, outer: DoubleArray, count: Int): Domain {
        val holes = ArrayList<DoubleArray>()
        for (k in 0 until count) {
            val angle = 2 * Math.PI * k / count
            val scale = 0.25 * (0.05 + 0.6 * r.nextDouble()) / Math.max(1.0, count / 3.0)
            val hole = star(r, 3 + r.nextInt(20), 0.7, 1)
            holes.add(placed(hole, 0.5 * StrictMath.cos(angle), 0.5 * StrictMath.sin(angle), scale))
        }
        return built(outer, holes)
    }

    private fun needle(r: Random): DoubleArray {
        val tip = StrictMath.pow(10.0, -1 - 3 * r.nextDouble())
        return uneven(r, doubleArrayOf(0.0, 0.0, 1.0, -tip, 2.0, 0.0, 1.0, tip * r.nextDouble()), 2.0)
    }

    private fun thinGap(r: Random): Domain {
        val gap = StrictMath.pow(10.0, -1 - 5 * r.nextDouble())
        val outer = subdivided(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), 2 + r.nextInt(10))
        val side = 0.3
        val hole = doubleArrayOf(gap, 0.3, gap + side, 0.3, gap + side, 0.6, gap, 0.6)
        return built(outer, listOf(subdivided(hole, 1 + r.nextInt(5))))
    }

    private fun comb(r: Random): DoubleArray {
        val teeth = 2 + r.nextInt(12)
        val out = arrayListOf(0.0, -0.3)
        out.addAll(listOf(2.0 * teeth, -0.3))
        for (k in teeth - 1 downTo 0) {
            val width = 0.02 + 1.7 * r.nextDouble()
            val height = 0.5 + 5 * r.nextDouble()
            out.addAll(listOf(2.0 * k + 1.9, 0.0, 2.0 * k + 1.9, height, 2.0 * k + 1.9 - width, height, 2.0 * k + 1.9 - width, 0.0))
        }
        return subdivided(out.toDoubleArray(), 1 + r.nextInt(6))
    }

    private fun spiral(r: Random): DoubleArray {
        val turns = 1.0 + 3 * r.nextDouble()
        val n = (25 * turns).toInt() + r.nextInt(150)
        val thickness = 0.05 + 0.8 * r.nextDouble()
        val out = DoubleArray(4 * n)
        for (k in 0 until n) {
            val angle = 2 * Math.PI * turns * k / (n - 1)
            val radius = 0.5 + angle / (2 * Math.PI)
            out[2 * k] = radius * StrictMath.cos(angle)
            out[2 * k + 1] = radius * StrictMath.sin(angle)
            out[4 * n - 2 - 2 * k] = (radius + thickness) * StrictMath.cos(angle)
            out[4 * n - 1 - 2 * k] = (radius + thickness) * StrictMath.sin(angle)
        }
        return out
    }

    private fun sizeStep(r: Random): Domain {
        val outer = subdivided(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), 1 + r.nextInt(4))
        val small = StrictMath.pow(10.0, -1 - 4 * r.nextDouble())
        return built(outer, listOf(placed(star(r, 6 + r.nextInt(12), 0.1, 1), 0.4, 0.55, small)))
    }

    private fun touchingHoles(r: Random): Domain {
        val builder = Domain.builder().outer(subdivided(doubleArrayOf(-2.0, -2.0, 2.0, -2.0, 2.0, 2.0, -2.0, 2.0), 2 + r.nextInt(8)))
        val petals = 2 + r.nextInt(5)
        for (k in 0 until petals) {
            val from = 2 * Math.PI * k / petals
            val to = from + 2 * Math.PI / petals * (0.2 + 0.6 * r.nextDouble())
            val length = 0.3 + r.nextDouble()
            builder.hole(
                doubleArrayOf(
                    0.0, 0.0, length * StrictMath.cos(from), length * StrictMath.sin(from),
                    length * StrictMath.cos(to), length * StrictMath.sin(to),
                ),
            )
        }
        return builder.build()
    }

    private fun islandInHole(r: Random): Domain {
        val builder = Domain.builder()
        var scale = 1.0
        repeat(2 + r.nextInt(4)) {
            builder.loop(placed(star(r, 8 + r.nextInt(30), 0.25, 1), 0.0, 0.0, scale))
            scale *= 0.2 + 0.3 * r.nextDouble()
        }
        return builder.build()
    }

    private fun plate(r: Random): Domain {
        val n = 2 + r.nextInt(9)
        val builder = Domain.builder()
            .outer(subdivided(doubleArrayOf(0.0, 0.0, n.toDouble(), 0.0, n.toDouble(), n.toDouble(), 0.0, n.toDouble()), 1 + r.nextInt(3 * n)))
        for (k in 0 until n * n) {
            val size = 0.49 * StrictMath.pow(10.0, -2 * r.nextDouble())
            builder.hole(placed(star(r, 3 + r.nextInt(14), 0.3, 1), k % n + 0.5, k / n + 0.5, size))
        }
        return builder.build()
    }

    /** A staircase on a grid of integers. */
    private fun polygonOnGrid(r: Random): DoubleArray {
        val steps = 2 + r.nextInt(8)
        val out = arrayListOf(0.0, 0.0, 2.0 * steps, 0.0)
        for (k in steps downTo 1) {
            val height = (1 + r.nextInt(4)).toDouble() + 4 * (steps - k)
            out.addAll(listOf(2.0 * k, height, 2.0 * k - 2, height))
        }
        return out.toDoubleArray()
    }

    private fun moved(r: Random, loop: DoubleArray): DoubleArray {
        if (r.nextBoolean()) return placed(loop, 1e7 * (r.nextDouble() - 0.5), 1e7 * r.nextDouble(), 1.0)
        return placed(loop, 0.0, 0.0, StrictMath.pow(10.0, -9 + 18 * r.nextDouble()))
    }

    private fun embeddedLine(r: Random): Domain {
        val outer = star(r, 12 + r.nextInt(40), 0.2, 1)
        val n = 2 + r.nextInt(6)
        val line = DoubleArray(2 * n) { if (it % 2 == 0) -0.5 + it / 2.0 / (n - 1) else 0.3 * (r.nextDouble() - 0.5) }
        return Domain.builder().outer(outer).embed(line, "line").build()
    }

    /** A star with nodes one unit in the last place beside others. */
    private fun neighbouringPlaces(r: Random): DoubleArray {
        val loop = star(r, 6 + r.nextInt(20), 0.3, 1)
        val n = loop.size / 2
        val out = ArrayList<Double>()
        for (i in 0 until n) {
            out.addAll(listOf(loop[2 * i], loop[2 * i + 1]))
            if (r.nextInt(3) > 0) continue
            val j = (i + 1) % n
            out.add(Math.nextAfter(loop[2 * i], loop[2 * j]))
            out.add(Math.nextAfter(loop[2 * i + 1], loop[2 * j + 1]))
        }
        return out.toDoubleArray()
    }
}
