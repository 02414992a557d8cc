package org.trigrid.reliability

import java.util.Random

/** Closed loops, x0, y0, x1, y1, …, of which random domains are made. */
internal object RandomLoops {
    /** A loop round the origin, radius 1 lowered by up to [noise]; [smoothness] averages the radii of neighbours. */
    fun star(r: Random, n: Int, noise: Double, smoothness: Int): DoubleArray {
        var radii = DoubleArray(n) { 1 - noise * r.nextDouble() }
        repeat(smoothness - 1) { radii = DoubleArray(n) { (radii[it] + radii[(it + 1) % n]) / 2 } }
        return DoubleArray(2 * n) {
            val angle = 2 * Math.PI * (it / 2 + 0.4 * Math.sin(it / 2 * 12.9)) / n
            radii[it / 2] * if (it % 2 == 0) StrictMath.cos(angle) else StrictMath.sin(angle)
        }
    }

    /** Splits the edges into pieces whose lengths differ by up to 10^[decades]. */
    fun uneven(r: Random, loop: DoubleArray, decades: Double): DoubleArray {
        val out = ArrayList<Double>()
        val n = loop.size / 2
        for (i in 0 until n) {
            val pieces = 1 + r.nextInt(12)
            val lengths = DoubleArray(pieces) { StrictMath.pow(10.0, -decades * r.nextDouble()) }
            val sum = lengths.sum()
            var t = 0.0
            for (k in 0 until pieces) {
                val j = (i + 1) % n
                out.add(loop[2 * i] + t * (loop[2 * j] - loop[2 * i]))
                out.add(loop[2 * i + 1] + t * (loop[2 * j + 1] - loop[2 * i + 1]))
                t += lengths[k] / sum
            }
        }
        return out.toDoubleArray()
    }

    fun placed(loop: DoubleArray, x: Double, y: Double, scale: Double): DoubleArray =
        DoubleArray(loop.size) { loop[it] * scale + if (it % 2 == 0) x else y }

    fun subdivided(loop: DoubleArray, pieces: Int): DoubleArray {
        val n = loop.size / 2
        return DoubleArray(2 * n * pieces) {
            val i = it / 2 / pieces
            val t = (it / 2 % pieces) / pieces.toDouble()
            val from = loop[2 * i + it % 2]
            from + t * (loop[(2 * i + 2) % loop.size + it % 2] - from)
        }
    }

    /** The square from ([x], [y]) with the [side] given, anticlockwise. */
    fun square(x: Double, y: Double, side: Double): DoubleArray =
        doubleArrayOf(x, y, x + side, y, x + side, y + side, x, y + side)

    /** A wavy ring of [n] nodes. */
    fun ring(n: Int): DoubleArray = DoubleArray(2 * n) {
        val angle = 2 * Math.PI * (it / 2) / n
        val radius = 1 + 0.3 * StrictMath.sin(9 * angle) + 0.01 * StrictMath.sin(1001 * angle)
        radius * if (it % 2 == 0) StrictMath.cos(angle) else StrictMath.sin(angle)
    }
}
