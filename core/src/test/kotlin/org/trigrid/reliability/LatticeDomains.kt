package org.trigrid.reliability

import org.trigrid.RandomDomains.Family
import org.trigrid.domain.Domain
import org.trigrid.reliability.RandomLoops.square
import java.util.Random

/**
 * Polygons of small whole coordinates, put where one step is one unit in the last place of the doubles, or a power of two of
 * it: valid exactly, with no double between neighbouring nodes, so that no inner node fits in.
 */
internal object LatticeDomains {
    val families: List<Family> = listOf(
        Family("lattice profile") { lone(it, profile(it), Math.scalb(1.0, it.nextInt(60) - 30), 0.0) },
        Family("lattice star") { lone(it, star(it), Math.scalb(1.0, it.nextInt(60) - 30), 0.0) },
        Family("one ulp profile at an offset") { lone(it, profile(it), offset(it)) },
        Family("one ulp star at an offset") { lone(it, star(it), offset(it)) },
        Family("one ulp hole in a large domain", every = 4) { hole(it) },
    )

    private val OFFSETS = doubleArrayOf(1e7, -1e7, 1.0, 3e-5, 1e9, 12345678.9)

    private fun offset(r: Random) = OFFSETS[r.nextInt(OFFSETS.size)]

    private fun lone(r: Random, cells: IntArray, offset: Double): Domain =
        lone(r, cells, Math.ulp(offset) * (1 shl r.nextInt(3) * r.nextInt(6)), offset)

    private fun lone(r: Random, cells: IntArray, step: Double, offset: Double): Domain {
        val turn = r.nextInt(4)
        return Domain.of(DoubleArray(cells.size) { offset + step * turned(cells, it, turn) })
    }

    private fun turned(cells: IntArray, i: Int, turn: Int): Int {
        val value = if (turn and 1 == 0) cells[i] else cells[i xor 1]
        return if (turn and 2 == 0) value else -value
    }

    private fun hole(r: Random): Domain {
        val cells = if (r.nextBoolean()) profile(r) else star(r)
        val place = 0.25 + 0.5 * r.nextDouble()
        val hole = DoubleArray(cells.size) { place + Math.ulp(place) * cells[it] / 4 * 4 }
        val outer = RandomLoops.subdivided(square(0.0, 0.0, 1.0), 1 + r.nextInt(6))
        return Domain.builder().outer(outer).hole(hole).build()
    }

    /** Columns one wide, from -low to +high, walked over every lattice point, or over the corners and some. */
    private fun profile(r: Random): IntArray {
        val columns = 1 + r.nextInt(10)
        val most = 1 + r.nextInt(6)
        val high = IntArray(columns) { 1 + r.nextInt(most) }
        val low = IntArray(columns) { 1 + r.nextInt(most) }
        val out = ArrayList<Int>()
        val all = r.nextBoolean()
        for (k in 0 until columns) {
            if (k > 0) walk(out, k, -low[k - 1], k, -low[k], all)
            walk(out, k, -low[k], k + 1, -low[k], all)
        }
        walk(out, columns, -low[columns - 1], columns, high[columns - 1], all)
        for (k in columns - 1 downTo 0) {
            walk(out, k + 1, high[k], k, high[k], all)
            walk(out, k, high[k], k, if (k > 0) high[k - 1] else -low[0], all)
        }
        return out.toIntArray()
    }

    /** From one lattice point to the next but for the last, on every point between or none. */
    private fun walk(out: ArrayList<Int>, x0: Int, y0: Int, x1: Int, y1: Int, all: Boolean) {
        val steps = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0))
        for (i in 0 until if (all) steps else Math.min(1, steps)) {
            out.add(x0 + Integer.signum(x1 - x0) * i)
            out.add(y0 + Integer.signum(y1 - y0) * i)
        }
    }

    /** Lattice points of different directions round the origin, by their angle: a polygon that the origin sees. */
    private fun star(r: Random): IntArray {
        val most = 2 + r.nextInt(9)
        val points = LinkedHashMap<Pair<Int, Int>, IntArray>()
        for (corner in listOf(intArrayOf(1, 0), intArrayOf(0, 1), intArrayOf(-1, 0), intArrayOf(0, -1))) put(points, corner[0], corner[1], most, r)
        repeat(r.nextInt(30)) { put(points, r.nextInt(2 * most + 1) - most, r.nextInt(2 * most + 1) - most, 1, r) }
        val sorted = points.values.sortedBy { StrictMath.atan2(it[1].toDouble(), it[0].toDouble()) }
        return IntArray(2 * sorted.size) { sorted[it / 2][it % 2] }
    }

    private fun put(points: LinkedHashMap<Pair<Int, Int>, IntArray>, x: Int, y: Int, stretch: Int, r: Random) {
        if (x == 0 && y == 0) return
        var a = Math.abs(x)
        var b = Math.abs(y)
        while (b != 0) a = b.also { b = a % b }
        val times = 1 + r.nextInt(stretch)
        points.putIfAbsent(Pair(x / a, y / a), intArrayOf(x * times, y * times))
    }
}
