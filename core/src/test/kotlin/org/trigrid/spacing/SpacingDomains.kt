package org.trigrid.spacing

import org.trigrid.domain.Domain
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.pow
import kotlin.math.sin
import kotlin.random.Random

/** Domains made directly from loops, for the tests of the spacing package. */
internal object SpacingDomains {
    /** Loops as x0, y0, x1, y1, …, the domain on their left; equal places become one node. */
    fun of(vararg loops: DoubleArray): Domain = withLines(loops.toList(), emptyList())

    /** As [of], with embedded open lines. */
    fun withLines(loops: List<DoubleArray>, lines: List<DoubleArray>): Domain {
        val numbers = LinkedHashMap<List<Double>, Int>()
        val segments = ArrayList<Int>()
        val embedded = ArrayList<Boolean>()
        fun add(line: DoubleArray, closed: Boolean) {
            val nodes = (0 until line.size / 2).map { i ->
                numbers.getOrPut(listOf(line[2 * i] + 0.0, line[2 * i + 1] + 0.0)) { numbers.size }
            }
            for (i in 0 until if (closed) nodes.size else nodes.size - 1) {
                segments += nodes[i]
                segments += nodes[(i + 1) % nodes.size]
                embedded += !closed
            }
        }
        loops.forEach { add(it, true) }
        lines.forEach { add(it, false) }
        val xy = numbers.keys.flatten().toDoubleArray()
        return Domain(xy, segments.toIntArray(), IntArray(embedded.size), embedded.toBooleanArray(), listOf("b"), "domain")
    }

    fun circle(cx: Double, cy: Double, radius: Double, count: Int, clockwise: Boolean = false): DoubleArray {
        val loop = DoubleArray(2 * count)
        for (i in 0 until count) {
            val angle = 2 * PI * i / count
            loop[2 * i] = cx + radius * cos(angle)
            loop[2 * i + 1] = cy + radius * sin(if (clockwise) -angle else angle)
        }
        return loop
    }

    /** A star-shaped loop; [roughness] 0 is smooth, near 1 jagged; angles crowd together by a random power. */
    fun star(random: Random, count: Int, roughness: Double): DoubleArray {
        val crowding = 1 + 3 * random.nextDouble() * roughness
        val loop = DoubleArray(2 * count)
        for (i in 0 until count) {
            val angle = 2 * PI * ((i + 0.9 * roughness * random.nextDouble()) / count).pow(crowding)
            val radius = 1 + roughness * (random.nextDouble() - 0.5) * 1.9
            loop[2 * i] = radius * cos(angle)
            loop[2 * i + 1] = radius * sin(angle)
        }
        return loop
    }

    /** A rectangle of whole coordinates with [holes] unit-square holes on a lattice, every node on the lattice. */
    fun lattice(width: Int, height: Int): Domain {
        val outer = ArrayList<Double>()
        for (x in 0 until width) outer += listOf(x.toDouble(), 0.0)
        for (y in 0 until height) outer += listOf(width.toDouble(), y.toDouble())
        for (x in width downTo 1) outer += listOf(x.toDouble(), height.toDouble())
        for (y in height downTo 1) outer += listOf(0.0, y.toDouble())
        val loops = arrayListOf(outer.toDoubleArray())
        for (x in 1 until width - 1 step 2) {
            for (y in 1 until height - 1 step 2) {
                val a = x.toDouble()
                val b = y.toDouble()
                loops += doubleArrayOf(a, b, a, b + 1, a + 1, b + 1, a + 1, b)
            }
        }
        return of(*loops.toTypedArray())
    }

    /** Teeth of height 1 and width [width], slanted by [slant], nodes only at their ends. */
    fun comb(teeth: Int, width: Double, slant: Double): Domain {
        val loop = ArrayList<Double>()
        for (i in 0 until teeth) {
            val x = 2 * i * width
            loop += listOf(x, 0.0, x + width, 0.0, x + width + slant, 1.0, x + 2 * width + slant, 1.0)
        }
        val right = 2 * teeth * width + slant
        loop += listOf(right + width, 1.0, right + width, 2.0, -slant - 1, 2.0, -slant - 1, 0.0)
        return of(loop.toDoubleArray())
    }

    fun moved(domain: Domain, scale: Double, dx: Double, dy: Double): Domain {
        val xy = DoubleArray(domain.xy.size) { scale * domain.xy[it] + if (it % 2 == 0) dx else dy }
        return Domain(xy, domain.segments, domain.segmentTags, domain.embedded, domain.tags, domain.regionMap, domain.points)
    }

    /** A square whose sides carry nodes at distances that grow from [finest] by [ratio] from each corner. */
    fun gradedSquare(finest: Double, ratio: Double): Domain {
        val half = ArrayList<Double>()
        var at = 0.0
        var step = finest
        while (at + step < 0.5) {
            half += at
            at += step
            step *= ratio
        }
        val side = half + 0.5 + half.drop(1).reversed().map { 1 - it }
        val loop = ArrayList<Double>()
        side.forEach { loop += listOf(it, 0.0) }
        side.forEach { loop += listOf(1.0, it) }
        side.forEach { loop += listOf(1 - it, 1.0) }
        side.forEach { loop += listOf(0.0, 1 - it) }
        return of(loop.toDoubleArray())
    }

    /** A square with [count] nodes on each side, in line. */
    fun square(count: Int, side: Double = 1.0): DoubleArray {
        val loop = DoubleArray(8 * count)
        for (i in 0 until 4 * count) {
            val t = side * (i % count) / count
            val edge = floor(i.toDouble() / count).toInt()
            loop[2 * i] = when (edge) { 0 -> t; 1 -> side; 2 -> side - t; else -> 0.0 }
            loop[2 * i + 1] = when (edge) { 0 -> 0.0; 1 -> t; 2 -> side; else -> side - t }
        }
        return loop
    }
}
