package org.trigrid.spacing

/**
 * How many elements a size field asks for: the integral of `4 / (sqrt(3) h^2)` over the domain, each equilateral triangle
 * of side h having the area `sqrt(3) h^2 / 4`.
 *
 * Triangles of the domain's triangulation are halved across their longest side until the size changes little in each piece.
 */
internal class ElementEstimate(private val mesh: ConstrainedDelaunay, private val field: SizeField) {
    private val longestAllowed = if (field is BoundedField) field.detail else Double.POSITIVE_INFINITY

    /** 9 per piece that waits: x, y, size of its three corners. */
    private var pieces = DoubleArray(9 * 64)
    private var pieceCount = 0
    private var piecesLeft = MAX_PIECES
    private var hint = -1

    /** The expected number of elements; never below the number that the boundary alone makes necessary. */
    fun total(): Double {
        val sizes = DoubleArray(mesh.xy.size / 2) { node ->
            if (mesh.edgeOfNode[node] < 0) 1.0 else field.sizeAt(mesh.xy[2 * node], mesh.xy[2 * node + 1], field.hintOf(node))
        }
        var sum = 0.0
        for (t in 0 until mesh.triangleCount) {
            hint = field.hintOf(mesh.nodes[3 * t])
            pieceCount = 0
            for (k in 0..2) {
                val node = mesh.nodes[3 * t + k]
                putCorner(k, mesh.xy[2 * node], mesh.xy[2 * node + 1], sizes[node])
            }
            pieceCount = 1
            while (pieceCount > 0) sum += elementsOrDivide()
        }
        return Math.max(sum, mesh.triangleCount.toDouble())
    }

    private fun putCorner(corner: Int, x: Double, y: Double, size: Double) {
        val p = 9 * pieceCount + 3 * corner
        pieces[p] = x
        pieces[p + 1] = y
        pieces[p + 2] = size
    }

    /** Elements of the last piece, or 0 when it was divided and waits in two halves. */
    private fun elementsOrDivide(): Double {
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
        const val EVEN = 1.4
        const val MAX_PIECES = 1_000_000
    }
}
