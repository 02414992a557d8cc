package org.trigrid.regions

import org.trigrid.domain.Domain
import org.trigrid.domain.Region
import org.trigrid.reliability.RandomLoops.placed
import org.trigrid.reliability.RandomLoops.ring
import org.trigrid.reliability.RandomLoops.star
import org.trigrid.reliability.RandomLoops.subdivided
import java.util.Random

/** Random domains of several regions whose areas are known beforehand. */
internal object RegionDomains {
    /** A domain with the area that each of its regions must have. */
    class Expected(val name: String, val domain: Domain, val areas: Map<String, Double>)

    fun make(seed: Int): Expected {
        val r = Random(7919L * seed + 1)
        return when (seed % 4) {
            0 -> cells(r)
            1 -> nested(r)
            2 -> inclusions(r)
            else -> cut(r)
        }
    }

    /** A grid of crooked cells, each a region's outline: T-shaped and four-armed junctions, several cells a region, gaps. */
    fun cells(r: Random): Expected {
        val width = 2 + r.nextInt(4)
        val height = 1 + r.nextInt(4)
        val nodes = Array((width + 1) * (height + 1)) { i ->
            doubleArrayOf(i % (width + 1) + 0.5 * (r.nextDouble() - 0.5), i / (width + 1) + 0.5 * (r.nextDouble() - 0.5))
        }
        val pieces = 1 + r.nextInt(4)
        val builder = Domain.builder()
        val areas = LinkedHashMap<String, Double>()
        for (cell in 0 until width * height) {
            if (r.nextInt(8) == 0 && areas.isNotEmpty()) continue
            val first = cell / width * (width + 1) + cell % width
            val corners = listOf(first, first + 1, first + width + 2, first + width + 1)
            val loop = DoubleArray(8) { nodes[corners[it / 2]][it % 2] }
            val name = "r${r.nextInt(3)}"
            builder.region(divided(loop, pieces), Region.of(name), "side")
            areas.merge(name, Math.abs(area(loop)), Double::plus)
        }
        return Expected("cells", builder.build(), areas)
    }

    /** Rings in rings, told by points; every second loop would be a hole but for the point in it. */
    fun nested(r: Random): Expected {
        val depth = 2 + r.nextInt(4)
        val builder = Domain.builder()
        val areas = LinkedHashMap<String, Double>()
        val loops = List(depth) { placed(star(r, 12 + r.nextInt(20), 0.2, 1), 0.0, 0.0, StrictMath.pow(0.5, it.toDouble())) }
        for ((k, loop) in loops.withIndex()) {
            builder.loop(loop, "ring $k")
            val inside = if (k + 1 < depth) Math.abs(area(loops[k + 1])) else 0.0
            areas["region $k"] = Math.abs(area(loop)) - inside
            val x = 0.5 * loop[0] + 0.5 * (if (k + 1 < depth) loops[k + 1][0] * 1.01 else 0.0)
            val y = 0.5 * loop[1] + 0.5 * (if (k + 1 < depth) loops[k + 1][1] * 1.01 else 0.0)
            builder.region(x, y, Region.of("region $k").withMaterial(10 + k))
        }
        return Expected("nested", builder.build(), areas)
    }

    /** A plate with holes, some of which are filled, and some given twice: as a hole and as an outline. */
    fun inclusions(r: Random): Expected {
        val plate = subdivided(doubleArrayOf(0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0), 4 + r.nextInt(12))
        val builder = Domain.builder().regionName("plate").outer(plate, "rim")
        val areas = linkedMapOf("plate" to 16.0)
        for (k in 0 until 9) {
            val hole = placed(ring(6 + r.nextInt(24)), 0.7 + 1.3 * (k % 3), 0.7 + 1.3 * (k / 3), 0.15 + 0.3 * r.nextDouble())
            val name = "fill ${r.nextInt(3)}"
            when (r.nextInt(4)) {
                0 -> builder.hole(hole, "hole")
                1 -> builder.hole(hole, "hole").region(hole, Region.of(name), "again")
                2 -> builder.region(hole, Region.of(name), "inclusion")
                else -> builder.embedLoop(hole, "inclusion").region(0.7 + 1.3 * (k % 3), 0.7 + 1.3 * (k / 3), Region.of(name))
            }
            val size = Math.abs(area(hole))
            areas.merge("plate", -size, Double::plus)
            val isFilled = builder.build().let { d -> (0 until d.loopCount).none { d.isHole(it) && d.loopNodes(it).any { n -> d.x(n) == hole[0] && d.y(n) == hole[1] } } }
            if (isFilled) areas.merge(name, size, Double::plus)
        }
        return Expected("inclusions", builder.build(), areas)
    }

    /** A square cut by a line from side to side, and one half again by a line from there to the rim. */
    fun cut(r: Random): Expected {
        val n = 4 + r.nextInt(10)
        val square = subdivided(doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0), 2 * n)
        val turn = 0.2 * (r.nextDouble() - 0.5)
        val line = ArrayList<Double>()
        for (i in 0..2 * n) {
            line.add(0.5 + (if (i == 0 || i == 2 * n) 0.0 else turn * StrictMath.sin(Math.PI * i / n)))
            line.add(i / (2.0 * n))
        }
        val middle = 2 * n
        val branch = ArrayList<Double>()
        for (i in 0..n) {
            branch.add(if (i == 0) line[middle] else if (i == n) 1.0 else line[middle] + (1 - line[middle]) * i / n)
            branch.add(0.5)
        }
        val builder = Domain.builder().outer(square, "rim").embed(line.toDoubleArray(), "cut").embed(branch.toDoubleArray(), "branch")
        builder.region(0.1, 0.5, Region.of("left")).region(0.9, 0.1, Region.of("lower")).region(0.9, 0.9, Region.of("upper"))
        val leftLoop = doubleArrayOf(0.0, 1.0, 0.0, 0.0) + line.toDoubleArray()
        val left = Math.abs(area(leftLoop))
        val lowerLoop = line.subList(0, middle + 2).toDoubleArray() + doubleArrayOf(1.0, 0.5, 1.0, 0.0)
        val lower = Math.abs(area(lowerLoop))
        return Expected("cut", builder.build(), linkedMapOf("left" to left, "lower" to lower, "upper" to 1 - left - lower))
    }

    /** Sides in equal pieces that come out the same from either end. */
    fun divided(loop: DoubleArray, pieces: Int): DoubleArray {
        val result = ArrayList<Double>()
        val n = loop.size / 2
        for (i in 0 until n) {
            val a = doubleArrayOf(loop[2 * i], loop[2 * i + 1])
            val b = doubleArrayOf(loop[2 * ((i + 1) % n)], loop[2 * ((i + 1) % n) + 1])
            for (k in 0 until pieces) {
                for (c in 0..1) result.add(if (k == 0) a[c] else (a[c] * (pieces - k) + b[c] * k) / pieces)
            }
        }
        return result.toDoubleArray()
    }

    fun area(loop: DoubleArray): Double {
        var twice = 0.0
        val n = loop.size / 2
        for (i in 0 until n) {
            val j = (i + 1) % n
            twice += loop[2 * i] * loop[2 * j + 1] - loop[2 * j] * loop[2 * i + 1]
        }
        return twice / 2
    }
}
