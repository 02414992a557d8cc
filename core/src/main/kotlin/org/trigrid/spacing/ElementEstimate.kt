package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint

/**
 * How many elements a size field asks for: the integral of `4 / (sqrt(3) h^2)` over the domain, each equilateral triangle
 * of side h having the area `sqrt(3) h^2 / 4`.
 *
 * Triangles of the domain's triangulation are halved across their longest side until the size changes little in each piece.
 * Of many triangles, as a boundary of a million nodes has, only a sample is worked out: they are sorted into classes by what
 * they could hold at most, and each class counts as much more than its sample as its bound is larger.
 */
internal class ElementEstimate(
    private val mesh: ConstrainedDelaunay,
    private val field: SizeField,
    private val checkpoint: Checkpoint,
) {
    private val longestAllowed = field.detail

    /** 9 per piece that waits: x, y, size of its three corners. */
    private var pieces = DoubleArray(9 * 64)
    private var pieceCount = 0
    private var piecesLeft = 0L
    private var hint = -1

    /** The expected number of elements; never below the number that the boundary alone makes necessary. */
    fun total(): Double {
        val sizes = DoubleArray(mesh.xy.size / 2) { node ->
            checkpoint.pass()
            if (mesh.edgeOfNode[node] < 0) 1.0 else field.sizeAt(mesh.xy[2 * node], mesh.xy[2 * node + 1], field.hintOf(node))
        }
        val classes = TriangleClasses(DoubleArray(mesh.triangleCount) {
            checkpoint.pass()
            mostElements(it, sizes)
        })
        piecesLeft = MAX_PIECES + PIECES_PER_TRIANGLE * classes.sampleSize
        for (t in 0 until mesh.triangleCount) {
            checkpoint.pass()
            if (classes.isSampled(t)) classes.add(t, elementsOf(t, sizes))
        }
        return Math.max(classes.total(), mesh.triangleCount.toDouble())
    }

    /** If the smallest size of its corners ruled everywhere in it. */
    private fun mostElements(t: Int, sizes: DoubleArray): Double {
        val a = mesh.nodes[3 * t]
        val b = mesh.nodes[3 * t + 1]
        val c = mesh.nodes[3 * t + 2]
        val abx = mesh.xy[2 * b] - mesh.xy[2 * a]
        val aby = mesh.xy[2 * b + 1] - mesh.xy[2 * a + 1]
        val acx = mesh.xy[2 * c] - mesh.xy[2 * a]
        val acy = mesh.xy[2 * c + 1] - mesh.xy[2 * a + 1]
        return PER_AREA * 0.5 * Math.abs(abx * acy - aby * acx) * density(Math.min(sizes[a], Math.min(sizes[b], sizes[c])))
    }

    private fun elementsOf(t: Int, sizes: DoubleArray): Double {
        hint = field.hintOf(mesh.nodes[3 * t])
        pieceCount = 0
        for (k in 0..2) {
            val node = mesh.nodes[3 * t + k]
            putCorner(k, mesh.xy[2 * node], mesh.xy[2 * node + 1], sizes[node])
        }
        pieceCount = 1
        var sum = 0.0
        while (pieceCount > 0) sum += elementsOrDivide()
        return sum
    }

    private fun putCorner(corner: Int, x: Double, y: Double, size: Double) {
        val p = 9 * pieceCount + 3 * corner
        pieces[p] = x
        pieces[p + 1] = y
        pieces[p + 2] = size
    }

    /** Elements of the last piece, or 0 when it was divided and waits in two halves. */
    private fun elementsOrDivide(): Double {
        checkpoint.pass(STEPS_PER_PIECE)
        val p = 9 * --pieceCount
        val ax = pieces[p]
        val ay = pieces[p + 1]
        val ha = pieces[p + 2]
        val bx = pieces[p + 3]
        val by = pieces[p + 4]
        val hb = pieces[p + 5]
        val cx = pieces[p + 6]
        val cy = pieces[p + 7]
        val hc = pieces[p + 8]
        val area = 0.5 * Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))
        val least = Math.min(ha, Math.min(hb, hc))
        val ab = squared(bx - ax, by - ay)
        val bc = squared(cx - bx, cy - by)
        val ca = squared(ax - cx, ay - cy)
        val longest = Math.max(ab, Math.max(bc, ca))
        val isCoarse = longest > longestAllowed * longestAllowed
        if (piecesLeft <= 0 || (area < SMALL * least * least && !isCoarse)) return PER_AREA * area * meanDensity(ha, hb, hc)
        piecesLeft--
        val hab = sizeAt(0.5 * (ax + bx), 0.5 * (ay + by))
        val hbc = sizeAt(0.5 * (bx + cx), 0.5 * (by + cy))
        val hca = sizeAt(0.5 * (cx + ax), 0.5 * (cy + ay))
        val middle = sizeAt((ax + bx + cx) / 3, (ay + by + cy) / 3)
        val low = Math.min(Math.min(least, middle), Math.min(hab, Math.min(hbc, hca)))
        val high = Math.max(Math.max(Math.max(ha, hb), Math.max(hc, middle)), Math.max(hab, Math.max(hbc, hca)))
        if (high <= EVEN * low && !isCoarse) {
            val corners = density(ha) + density(hb) + density(hc)
            val sides = density(hab) + density(hbc) + density(hca)
            return PER_AREA * area * (corners / 20 + 2 * sides / 15 + 9 * density(middle) / 20)
        }
        val isDivided = when (longest) {
            ab -> divide(ax, ay, ha, bx, by, hb, cx, cy, hc, hab)
            bc -> divide(bx, by, hb, cx, cy, hc, ax, ay, ha, hbc)
            else -> divide(cx, cy, hc, ax, ay, ha, bx, by, hb, hca)
        }
        return if (isDivided) 0.0 else PER_AREA * area * meanDensity(ha, hb, hc)
    }

    /** Halves the piece between a and b, whose middle has the size [hm]; false where there is no double between the two. */
    private fun divide(
        ax: Double, ay: Double, ha: Double, bx: Double, by: Double, hb: Double, cx: Double, cy: Double, hc: Double, hm: Double,
    ): Boolean {
        val mx = 0.5 * (ax + bx)
        val my = 0.5 * (ay + by)
        if ((mx == ax || mx == bx) && (my == ay || my == by)) return false
        if (9 * (pieceCount + 2) > pieces.size) pieces = pieces.copyOf(2 * pieces.size)
        putCorner(0, ax, ay, ha)
        putCorner(1, mx, my, hm)
        putCorner(2, cx, cy, hc)
        pieceCount++
        putCorner(0, mx, my, hm)
        putCorner(1, bx, by, hb)
        putCorner(2, cx, cy, hc)
        pieceCount++
        return true
    }

    private fun sizeAt(x: Double, y: Double): Double {
        val size = field.sizeAt(x, y, hint)
        hint = field.lastHint
        return size
    }

    /** Exact up to second order for a size that is linear in the piece. */
    private fun meanDensity(a: Double, b: Double, c: Double) =
        (density(a) + density(b) + density(c)) / 12 + 0.75 * density((a + b + c) / 3)

    private fun density(size: Double) = 1 / (size * size)

    private fun squared(dx: Double, dy: Double) = dx * dx + dy * dy

    private companion object {
        /** 4 / sqrt(3) */
        const val PER_AREA = 2.309401076758503

        /** In squared sizes: a piece of about one element is not worth dividing. */
        const val SMALL = 0.5
        const val EVEN = 2.0

        /** Pieces that may be divided: many in few triangles, or some in each of many. */
        const val MAX_PIECES = 1_000_000L
        const val PIECES_PER_TRIANGLE = 50L

        /** A piece asks the field three times, which among thousands of holes takes long. */
        const val STEPS_PER_PIECE = 32
    }
}

/** Triangles by the power of two of the most elements that they could hold, and what was found for a sample of each class. */
private class TriangleClasses(private val most: DoubleArray) {
    private val counts = IntArray(CLASSES)
    private val passed = IntArray(CLASSES)
    private val sumOfMost = DoubleArray(CLASSES)
    private val sampledMost = DoubleArray(CLASSES)
    private val sampledElements = DoubleArray(CLASSES)

    init {
        for (t in most.indices) {
            counts[classOf(t)]++
            sumOfMost[classOf(t)] += most[t]
        }
    }

    val sampleSize: Int get() = counts.sumOf { Math.min(it, 2 * SAMPLE) }

    /** To be asked once for each triangle, in their order. */
    fun isSampled(t: Int): Boolean {
        val c = classOf(t)
        return passed[c]++ % Math.max(1, counts[c] / SAMPLE) == 0
    }

    fun add(t: Int, elements: Double) {
        sampledMost[classOf(t)] += most[t]
        sampledElements[classOf(t)] += elements
    }

    fun total(): Double {
        var sum = 0.0
        for (c in 0 until CLASSES) {
            if (counts[c] == 0) continue
            val share = if (sampledMost[c] > 0 && counts[c] >= 2 * SAMPLE) sumOfMost[c] / sampledMost[c] else 1.0
            sum += share * sampledElements[c]
        }
        return sum
    }

    private fun classOf(t: Int) = Math.max(0, Math.min(CLASSES - 1, Math.getExponent(most[t]) + SHIFT))

    private companion object {
        /** From a thousandth of an element to more than can be made. */
        const val CLASSES = 64
        const val SHIFT = 10
        const val SAMPLE = 1000
    }
}
