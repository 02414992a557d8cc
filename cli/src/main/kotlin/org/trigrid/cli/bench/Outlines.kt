package org.trigrid.cli.bench

import java.util.SplittableRandom

/** Closed lines as arrays x0, y0, x1, y1, …, the first point not repeated; anticlockwise. */
internal object Outlines {
    /** [count] equal segments round the circle. */
    fun circle(centreX: Double, centreY: Double, radius: Double, count: Int): DoubleArray =
        closed(count) { angle -> doubleArrayOf(centreX + radius * StrictMath.cos(angle), centreY + radius * StrictMath.sin(angle)) }

    /** The rectangle from the origin to ([width], [height]), each side in equal segments of about [spacing]. */
    fun rectangle(width: Double, height: Double, spacing: Double): DoubleArray {
        val across = Math.max(1, Math.round(width / spacing).toInt())
        val up = Math.max(1, Math.round(height / spacing).toInt())
        val points = ArrayList<Double>()
        fun side(fromX: Double, fromY: Double, toX: Double, toY: Double, count: Int) {
            for (i in 0 until count) {
                points.add(fromX + (toX - fromX) * i / count)
                points.add(fromY + (toY - fromY) * i / count)
            }
        }
        side(0.0, 0.0, width, 0.0, across)
        side(width, 0.0, width, height, up)
        side(width, height, 0.0, height, across)
        side(0.0, height, 0.0, 0.0, up)
        return points.toDoubleArray()
    }

    /** A NACA 0012 section of chord 1 from (0, 0) to (1, 0), closed at the trailing edge, in [count] fine steps. */
    fun airfoil(count: Int): DoubleArray = closed(2 * (count / 2)) { angle ->
        val x = 0.5 * (1 + StrictMath.cos(angle))
        val half = 0.6 * (0.2969 * Math.sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036))))
        doubleArrayOf(x, if (angle < Math.PI) half else -half)
    }

    /** A round body whose radius wavers with all wave numbers up to [waves], in [count] fine steps; star-shaped. */
    fun coast(centreX: Double, centreY: Double, radius: Double, waves: Int, seed: Long, count: Int): DoubleArray {
        val random = SplittableRandom(seed)
        val phases = DoubleArray(waves) { 2 * Math.PI * random.nextDouble() }
        val heights = DoubleArray(waves) { ROUGHNESS * StrictMath.pow(it + 2.0, -DECAY) * random.nextDouble() }
        return closed(count) { angle ->
            var r = 1.0
            for (k in 0 until waves) r += heights[k] * StrictMath.cos((k + 2) * angle + phases[k])
            doubleArrayOf(centreX + radius * r * StrictMath.cos(angle), centreY + radius * r * StrictMath.sin(angle))
        }
    }

    /**
     * Points along the closed line [fine] whose distance follows [spacing], a length for each place, but for [jitter],
     * 0 for none, as a part of the distance.
     */
    fun spaced(fine: DoubleArray, jitter: Double, spacing: (Double, Double) -> Double): DoubleArray {
        val count = fine.size / 2
        val steps = DoubleArray(count + 1)
        for (i in 0 until count) {
            val j = (i + 1) % count
            val length = Math.hypot(fine[2 * j] - fine[2 * i], fine[2 * j + 1] - fine[2 * i + 1])
            steps[i + 1] = steps[i] + length / spacing(0.5 * (fine[2 * i] + fine[2 * j]), 0.5 * (fine[2 * i + 1] + fine[2 * j + 1]))
        }
        val nodes = Math.max(LEAST_NODES, Math.round(steps[count]).toInt())
        val random = SplittableRandom(nodes.toLong())
        val result = DoubleArray(2 * nodes)
        var at = 0
        for (node in 0 until nodes) {
            val wanted = Math.max(0.0, (node + jitter * (random.nextDouble() - 0.5)) * steps[count] / nodes)
            while (steps[at + 1] < wanted) at++
            val t = (wanted - steps[at]) / (steps[at + 1] - steps[at])
            val next = (at + 1) % count
            result[2 * node] = fine[2 * at] + t * (fine[2 * next] - fine[2 * at])
            result[2 * node + 1] = fine[2 * at + 1] + t * (fine[2 * next + 1] - fine[2 * at + 1])
        }
        return result
    }

    private fun closed(count: Int, place: (Double) -> DoubleArray): DoubleArray {
        val xy = DoubleArray(2 * count)
        for (i in 0 until count) place(2 * Math.PI * i / count).copyInto(xy, 2 * i)
        return xy
    }

    private const val LEAST_NODES = 6
    private const val ROUGHNESS = 0.5
    private const val DECAY = 1.25
}
