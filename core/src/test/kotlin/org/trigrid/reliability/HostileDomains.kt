package org.trigrid.reliability

import org.trigrid.RandomDomains.Family
import org.trigrid.domain.Domain
import org.trigrid.domain.DomainBuilder
import org.trigrid.reliability.RandomLoops.placed
import org.trigrid.reliability.RandomLoops.square
import org.trigrid.reliability.RandomLoops.star
import org.trigrid.reliability.RandomLoops.subdivided
import org.trigrid.reliability.RandomLoops.uneven
import java.util.Random

/** Domains at the edge of what is valid: needles, gaps and steps of a million to one, loops that touch in nodes. */
internal object HostileDomains {
    val families: List<Family> = listOf(
        Family("needle fan") { needleFan(it) },
        Family("tiny gap") { tinyGap(it) },
        Family("step of a million", every = 2) { stepOfAMillion(it, 1) },
        Family("steps of a million", every = 50) { stepOfAMillion(it, 2 + it.nextInt(2)) },
        Family("thousands of holes", every = 200) { manyHoles(it, 1000 + it.nextInt(9001)) },
        Family("hundreds of holes", every = 20) { manyHoles(it, 100 + it.nextInt(900)) },
        Family("several components") { components(it) },
        Family("holes at outer nodes") { holesAtOuterNodes(it) },
        Family("pinched loop") { pinched(it) },
        Family("lines from boundary nodes") { linesFromBoundary(it) },
        Family("net of lines") { netOfLines(it) },
        Family("tangled polygon") { Domain.of(TangledPolygon.make(it, 4 + it.nextInt(40))) },
        Family("uneven tangle") { Domain.of(uneven(it, TangledPolygon.make(it, 4 + it.nextInt(10)), 3.0)) },
        Family("cocircular") { cocircular(it) },
        Family("snowflake") { snowflake(it) },
        Family("coarse and fine sides", every = 3) { coarseAndFine(it) },
    )

    private fun power(r: Random, low: Double, high: Double) = StrictMath.pow(10.0, low + (high - low) * r.nextDouble())

    /** Spikes of 10 to 0.001 degrees round a middle, outwards or as holes inwards that meet in one node. */
    private fun needleFan(r: Random): Domain {
        val spikes = 3 + r.nextInt(10)
        val width = Math.toRadians(power(r, -3.0, 1.0))
        if (r.nextBoolean()) {
            val out = DoubleArray(4 * spikes)
            for (k in 0 until spikes) {
                val angle = 2 * Math.PI * k / spikes
                val low = angle + Math.PI / spikes
                val foot = width / 2 / Math.sin(Math.PI / spikes)
                polar(out, 4 * k, 1 + r.nextDouble(), angle)
                polar(out, 4 * k + 2, Math.min(0.4, foot), low)
            }
            return Domain.of(uneven(r, out, 1.0))
        }
        val builder = Domain.builder().outer(subdivided(square(-3.0, -3.0, 6.0), 1 + r.nextInt(12)))
        for (k in 0 until spikes) {
            val angle = 2 * Math.PI * (k + 0.5 * r.nextDouble()) / spikes
            val hole = DoubleArray(6)
            val length = 0.5 + 2 * r.nextDouble()
            polar(hole, 2, length, angle)
            polar(hole, 4, length, angle + Math.min(width, 1.5 / spikes))
            builder.hole(hole)
        }
        return builder.build()
    }

    private fun polar(out: DoubleArray, at: Int, radius: Double, angle: Double) {
        out[at] = radius * StrictMath.cos(angle)
        out[at + 1] = radius * StrictMath.sin(angle)
    }

    /** A hole 1e-3 to 1e-9 from a side; nodes coarse, fine or as fine as the gap where it is. */
    private fun tinyGap(r: Random): Domain {
        val gap = power(r, -9.0, -3.0)
        val builder = Domain.builder()
        val outer = ArrayList<Double>()
        for (k in 0..r.nextInt(30)) outer.addAll(listOf(0.0, 1 - k / 31.0))
        if (r.nextBoolean()) {
            var t = gap
            while (t < 0.01) {
                outer.addAll(listOf(0.0, 0.02 - t))
                t *= 1.5
            }
        }
        outer.addAll(listOf(0.0, 0.0, 1.0, 0.0, 1.0, 1.0))
        builder.outer(outer.toDoubleArray())
        val low = 0.015 * r.nextDouble()
        val hole = doubleArrayOf(gap, low, 0.5, low, 0.5, 0.9, gap * (1 + r.nextInt(2)), 0.9)
        return builder.hole(if (r.nextBoolean()) hole else subdivided(hole, 1 + r.nextInt(20))).build()
    }

    /** Holes a million times finer than the rest; the smooth sizes between several of them ask for more than can be made. */
    private fun stepOfAMillion(r: Random, holes: Int): Domain {
        val fine = power(r, -7.0, -5.0)
        val outer = subdivided(square(0.0, 0.0, 1.0), 1 + r.nextInt(3))
        val builder = Domain.builder().outer(outer)
        for (k in 0 until holes) {
            val hole = star(r, 3 + r.nextInt(12), 0.2, 1)
            builder.hole(placed(hole, 0.25 + 0.25 * k, 0.3 + 0.4 * r.nextDouble(), fine * (1 + 9 * r.nextDouble())))
        }
        if (holes > 1 && r.nextBoolean()) builder.embed(doubleArrayOf(0.1, 0.1, 0.1 + fine, 0.1 + fine, 0.12, 0.1), "line")
        return builder.build()
    }

    private fun manyHoles(r: Random, count: Int): Domain {
        val n = Math.ceil(Math.sqrt(count.toDouble())).toInt()
        val builder = Domain.builder().outer(subdivided(square(0.0, 0.0, n.toDouble()), 1 + r.nextInt(2 * n)))
        for (k in 0 until count) {
            val size = 0.48 * power(r, -1.5, 0.0)
            builder.hole(placed(star(r, 3 + r.nextInt(6), 0.3, 1), k % n + 0.5, k / n + 0.5, size))
        }
        return builder.build()
    }

    /** Separate parts in a grid, of sizes apart by up to 1e4, with holes and islands; some meet their neighbours in a corner. */
    private fun components(r: Random): Domain {
        val n = 2 + r.nextInt(3)
        val builder = Domain.builder()
        for (k in 0 until n * n) {
            val x = 2.0 * (k % n)
            val y = 2.0 * (k / n)
            if (r.nextInt(3) == 0) {
                // Squares on the diagonals of a checkerboard share corners.
                if ((k % n + k / n) % 2 == 0) builder.loop(subdivided(square(x, y, 2.0), 1 + r.nextInt(8)))
                continue
            }
            if ((k % n + k / n) % 2 == 1) continue
            var scale = 0.95 * power(r, -4.0, 0.0)
            repeat(1 + r.nextInt(4)) {
                builder.loop(placed(star(r, 6 + r.nextInt(20), 0.3, 1), x + 1, y + 1, scale))
                scale *= 0.3
            }
        }
        return builder.loop(star(r, 7, 0.2, 1).let { placed(it, -5.0, 0.0, 1.0) }).build()
    }

    /** Holes, each with one node on the outer boundary; several may share it. */
    private fun holesAtOuterNodes(r: Random): Domain {
        val pieces = 2 + r.nextInt(8)
        val outer = subdivided(square(0.0, 0.0, pieces.toDouble()), pieces)
        val builder = Domain.builder().outer(outer)
        for (k in 1 until pieces) {
            val x = k.toDouble()
            val height = 0.2 + (pieces - 0.4) * r.nextDouble()
            when (r.nextInt(4)) {
                0 -> builder.hole(doubleArrayOf(x, 0.0, x + 0.4 * r.nextDouble(), height, x - 0.4, height * r.nextDouble()))
                1 -> {
                    builder.hole(doubleArrayOf(x, 0.0, x + 0.1, height, x + 0.3, height * 0.9))
                    builder.hole(doubleArrayOf(x, 0.0, x - 0.3, height * 0.9, x - 0.1, height))
                }
                // From the lower side to the upper one: the domain falls into parts that meet in nodes.
                2 -> builder.hole(subdivided(doubleArrayOf(x, 0.0, x + 0.3, pieces / 2.0, x, pieces.toDouble(), x - 0.2, pieces / 2.0), 1 + r.nextInt(3)))
            }
        }
        return builder.build()
    }

    /** One walk that passes through a node several times: lobes that meet in it, or a bay that closes in it. */
    private fun pinched(r: Random): Domain {
        val lobes = 2 + r.nextInt(4)
        val walk = ArrayList<Double>()
        val isBay = r.nextBoolean()
        if (isBay) walk.addAll(subdivided(doubleArrayOf(0.0, 0.0, 4.0, -3.0, 4.0, 5.0, -4.0, 5.0, -4.0, -3.0), 1 + r.nextInt(6)).toList())
        for (k in 0 until lobes) {
            val from = (if (isBay) Math.PI / 4 else 0.0) + (if (isBay) Math.PI / 2 else 2 * Math.PI) * k / lobes
            val to = from + (if (isBay) 1.2 else 5.0) / lobes
            walk.addAll(listOf(0.0, 0.0))
            val steps = 2 + r.nextInt(8)
            for (i in 0..steps) {
                val share = if (isBay) 1 - i / steps.toDouble() else i / steps.toDouble()
                val radius = (0.6 + 1.4 * r.nextDouble())
                val angle = from + (to - from) * share
                walk.addAll(listOf(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle)))
            }
        }
        return Domain.of(walk.toDoubleArray())
    }

    /** Embedded lines from node to node of the boundary, several from one node, at angles down to 0.001 degrees. */
    private fun linesFromBoundary(r: Random): Domain {
        val pieces = 2 + r.nextInt(10)
        val builder = Domain.builder().outer(subdivided(square(0.0, 0.0, pieces.toDouble()), pieces))
        val builderHole = doubleArrayOf(0.4, 0.6, 0.6, 0.6, 0.6, 0.8, 0.4, 0.8)
        builder.hole(builderHole)
        builder.embed(doubleArrayOf(0.0, 0.0, 0.4, 0.6), "to hole")
        if (r.nextBoolean()) builder.embed(doubleArrayOf(0.6, 0.8, pieces.toDouble(), pieces.toDouble()), "from hole")
        val node = 1.0 + r.nextInt(pieces - 1)
        var angle = 0.35
        for (k in 0..r.nextInt(6)) {
            val length = (1 + 0.4 * r.nextDouble()) * 0.35
            builder.embed(doubleArrayOf(node, 0.0, node + length * StrictMath.cos(angle), length * StrictMath.sin(angle)), "fan")
            angle += power(r, -5.0, -1.0)
        }
        for (k in 1 until pieces) if (r.nextInt(3) == 0) acrossTop(builder, pieces, k, r)
        return builder.build()
    }

    /** Cuts a corner of the square off from the left: both ends on the boundary. */
    private fun acrossTop(builder: DomainBuilder, pieces: Int, k: Int, r: Random) {
        val y = k.toDouble()
        if (y < 2) return
        builder.embed(doubleArrayOf(0.0, y, 0.05 + 0.1 * r.nextDouble(), y + 0.2, 0.2, y + 0.5 * r.nextDouble()), "left $pieces")
    }

    /** A net whose meshes are closed loops of embedded segments, hung on the boundary or free. */
    private fun netOfLines(r: Random): Domain {
        val n = 2 + r.nextInt(6)
        val builder = Domain.builder().outer(subdivided(square(0.0, 0.0, n.toDouble()), n))
        val xs = DoubleArray((n + 1) * (n + 1)) { it % (n + 1) + moved(it % (n + 1), n, r) }
        val ys = DoubleArray(xs.size) { it / (n + 1) + moved(it / (n + 1), n, r) }
        for (i in xs.indices) {
            val column = i % (n + 1)
            val row = i / (n + 1)
            val isRim = column == 0 || column == n
            if (column < n && row in 1 until n && r.nextInt(4) > 0) embed(builder, xs, ys, i, i + 1, column, n, row)
            if (row < n && !isRim && r.nextInt(4) > 0) embed(builder, xs, ys, i, i + n + 1, row, n, column)
        }
        return builder.build()
    }

    private fun moved(k: Int, n: Int, r: Random) = if (k == 0 || k == n) 0.0 else 0.3 * (r.nextDouble() - 0.5)

    /** A node on the rim keeps its whole coordinates. */
    private fun embed(builder: DomainBuilder, xs: DoubleArray, ys: DoubleArray, a: Int, b: Int, place: Int, n: Int, line: Int) {
        val xy = doubleArrayOf(xs[a], ys[a], xs[b], ys[b])
        val isRow = b == a + 1
        if (place == 0) xy[if (isRow) 1 else 0] = line.toDouble()
        if (place == n - 1) xy[if (isRow) 3 else 2] = line.toDouble()
        builder.embed(xy, "net")
    }

    /** Nodes on circles, which any triangulation of them is as Delaunay as any other. */
    private fun cocircular(r: Random): Domain {
        val n = 3 + r.nextInt(200)
        val builder = Domain.builder().outer(regular(n, 1.0, 0.0))
        if (r.nextBoolean()) builder.loop(regular(3 + r.nextInt(n), 0.45, Math.PI / n))
        if (r.nextBoolean()) builder.loop(regular(4, 0.1, Math.PI / 4))
        return builder.build()
    }

    private fun regular(n: Int, radius: Double, turn: Double): DoubleArray =
        DoubleArray(2 * n).also { for (k in 0 until n) polar(it, 2 * k, radius, turn + 2 * Math.PI * k / n) }

    /** Koch's curve: a boundary of many lengths and the same angles everywhere. */
    private fun snowflake(r: Random): Domain {
        var loop = regular(3 + r.nextInt(3), 1.0, 0.0)
        repeat(1 + r.nextInt(4)) { loop = koched(loop, 0.2 + 0.09 * r.nextDouble()) }
        return Domain.of(loop)
    }

    private fun koched(loop: DoubleArray, height: Double): DoubleArray {
        val out = DoubleArray(4 * loop.size)
        for (k in 0 until loop.size / 2) {
            val x = loop[2 * k]
            val y = loop[2 * k + 1]
            val dx = loop[(2 * k + 2) % loop.size] - x
            val dy = loop[(2 * k + 3) % loop.size] - y
            val places = doubleArrayOf(0.0, 0.0, 1 / 3.0, 0.0, 0.5, -height, 2 / 3.0, 0.0)
            for (i in 0..3) {
                out[8 * k + 2 * i] = x + places[2 * i] * dx - places[2 * i + 1] * dy
                out[8 * k + 2 * i + 1] = y + places[2 * i] * dy + places[2 * i + 1] * dx
            }
        }
        return out
    }

    /** Thin strips with a coarse long side against one with up to 2000 nodes. */
    private fun coarseAndFine(r: Random): Domain {
        val height = power(r, -4.0, 0.0)
        val n = 1 + r.nextInt(2000)
        val out = arrayListOf(0.0, 0.0)
        for (k in 0..n) out.addAll(listOf(1 - k / n.toDouble(), height))
        out.addAll(2, listOf(1.0, 0.0))
        return Domain.of(out.toDoubleArray())
    }
}
