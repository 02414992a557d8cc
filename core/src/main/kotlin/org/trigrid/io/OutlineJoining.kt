package org.trigrid.io

/**
 * Joins loose pieces to loops. Ends no farther than a tolerance from an end before them are moved to it; then each end must meet
 * exactly one other. Pieces that lie twice between the same ends count once where they are straight.
 *
 * @param join the tolerance, NaN for a millionth of the drawing's longer side.
 */
internal class OutlineJoining(pieces: List<OutlinePiece>, join: Double, private val complaint: Complaint) {
    private val pieces = pieces.filter { isLong(it.curve) }
    private val tolerance = if (join.isNaN()) STANDARD * longerSide() else join

    /** Places where pieces end; the first end there gives the coordinates. */
    private val places = EndPlaces(tolerance)
    private val begins = IntArray(this.pieces.size)
    private val ends = IntArray(this.pieces.size)

    private fun isLong(curve: PlaneCurve) = curve !is StraightLine || curve.beginX != curve.endX || curve.beginY != curve.endY

    private fun longerSide(): Double {
        var minX = Double.POSITIVE_INFINITY
        var maxX = Double.NEGATIVE_INFINITY
        var minY = Double.POSITIVE_INFINITY
        var maxY = Double.NEGATIVE_INFINITY
        for (piece in pieces) {
            for (u in piece.curve.knots) {
                minX = minOf(minX, piece.curve.x(u))
                maxX = maxOf(maxX, piece.curve.x(u))
                minY = minOf(minY, piece.curve.y(u))
                maxY = maxOf(maxY, piece.curve.y(u))
            }
        }
        return maxOf(maxX - minX, maxY - minY, 0.0)
    }

    fun addTo(outline: Outline) {
        val loose = ArrayList<Int>()
        val seen = HashSet<Long>()
        for ((i, piece) in pieces.withIndex()) {
            begins[i] = places.of(piece.curve.beginX, piece.curve.beginY)
            ends[i] = places.of(piece.curve.endX, piece.curve.endY)
            val isLine = piece.curve is StraightLine
            if (begins[i] == ends[i]) {
                if (!isLine) outline.loop(listOf(piece))
                continue
            }
            val key = (minOf(begins[i], ends[i]).toLong() shl 32) or maxOf(begins[i], ends[i]).toLong()
            if (isLine && !seen.add(key)) continue
            loose.add(i)
        }
        val meeting = Meeting(loose)
        meeting.requirePairs()
        val taken = BooleanArray(pieces.size)
        for (first in loose) if (!taken[first]) outline.loop(meeting.walk(first, taken))
    }

    /** Which pieces meet at each place. */
    private inner class Meeting(loose: List<Int>) {
        private val at = arrayOfNulls<IntArray>(places.count)

        init {
            for (i in loose) for (place in intArrayOf(begins[i], ends[i])) at[place] = (at[place] ?: IntArray(0)) + i
        }

        fun requirePairs() {
            for (place in at.indices) {
                val count = at[place]?.size ?: continue
                if (count == 2) continue
                val where = "at (${places.x(place)}, ${places.y(place)})"
                if (count > 2) complaint.fail("$count pieces of the outline meet $where, where two must")
                val (other, distance) = places.nearestOpen(place) { at[it]?.size == 1 }
                val hint = if (other < 0) "" else ": the nearest other end is $distance away; ends up to $tolerance are joined"
                complaint.fail("the outline is open $where$hint")
            }
        }

        fun walk(first: Int, taken: BooleanArray): List<OutlinePiece> {
            val loop = ArrayList<OutlinePiece>()
            var piece = first
            var from = begins[first]
            do {
                taken[piece] = true
                val isForward = begins[piece] == from
                val to = if (isForward) ends[piece] else begins[piece]
                val directed = if (isForward) pieces[piece] else pieces[piece].reversed()
                loop.add(OutlinePiece(MovedEnds.of(directed.curve, places, from, to), directed.tag))
                val here = piece
                from = to
                piece = at[to]!!.first { it != here }
            } while (!taken[piece])
            return loop
        }
    }

    private companion object {
        const val STANDARD = 1e-6
    }
}

/** A curve whose ends were moved to where they meet their neighbours. */
private class MovedEnds private constructor(
    private val curve: PlaneCurve,
    override val beginX: Double,
    override val beginY: Double,
    override val endX: Double,
    override val endY: Double,
) : PlaneCurve by curve {
    companion object {
        fun of(curve: PlaneCurve, places: EndPlaces, from: Int, to: Int): PlaneCurve = when {
            curve is StraightLine -> StraightLine(places.x(from), places.y(from), places.x(to), places.y(to))
            else -> MovedEnds(curve, places.x(from), places.y(from), places.x(to), places.y(to))
        }
    }
}

/** Numbers places; those within a tolerance of one before are that one. A grid of the tolerance's size finds them. */
internal class EndPlaces(private val tolerance: Double) {
    private val xs = ArrayList<Double>()
    private val ys = ArrayList<Double>()
    private val cells = HashMap<Cell, MutableList<Int>>()

    private data class Cell(val x: Double, val y: Double)

    val count: Int get() = xs.size

    fun x(place: Int): Double = xs[place]

    fun y(place: Int): Double = ys[place]

    fun of(x: Double, y: Double): Int {
        val cx = cell(x)
        val cy = cell(y)
        var best = -1
        var nearest = Double.POSITIVE_INFINITY
        for (dx in -1..1) {
            for (dy in -1..1) {
                for (place in cells[Cell(cx + dx, cy + dy)].orEmpty()) {
                    val distance = StrictMath.hypot(xs[place] - x, ys[place] - y)
                    if (distance <= tolerance && distance < nearest) {
                        best = place
                        nearest = distance
                    }
                }
            }
        }
        if (best >= 0) return best
        cells.getOrPut(Cell(cx, cy)) { ArrayList() }.add(xs.size)
        xs.add(x)
        ys.add(y)
        return xs.size - 1
    }

    /** Cells are as wide as the tolerance; without one each coordinate is its own, without -0. */
    private fun cell(value: Double): Double = (if (tolerance > 0) Math.floor(value / tolerance) else value) + 0.0

    /** The other place that [isOpen] and is nearest to [place], or -1, with its distance. */
    fun nearestOpen(place: Int, isOpen: (Int) -> Boolean): Pair<Int, Double> {
        var best = -1
        var nearest = Double.POSITIVE_INFINITY
        for (other in xs.indices) {
            val distance = StrictMath.hypot(xs[other] - xs[place], ys[other] - ys[place])
            if (other == place || !isOpen(other) || distance >= nearest) continue
            best = other
            nearest = distance
        }
        return Pair(best, nearest)
    }
}
