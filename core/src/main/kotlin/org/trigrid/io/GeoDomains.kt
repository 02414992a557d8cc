package org.trigrid.io

/** Makes a domain of each plane surface of a `.geo` script. */
internal class GeoDomains(private val model: GeoModel, private val input: DomainText) {
    fun domains(): List<NamedDomain> {
        if (model.surfaces.isEmpty()) model.complaint.fail("there is no Plane Surface in it")
        return model.surfaces.map { surface ->
            val own = model.surfaceNames[surface.number]
            val name = own ?: if (model.surfaces.size == 1) input.baseName else "${input.baseName}_${surface.number}"
            val outline = Outline(input, name)
            surface.loops.forEachIndexed { i, number ->
                val loop = model.loops[Math.abs(number)] ?: model.complaint.failAt(surface.place, "there is no loop $number")
                val pieces = ordered(loop)
                if (i == 0) outline.outer(pieces) else outline.hole(pieces)
            }
            for (number in model.inner[surface.number].orEmpty()) {
                val curve = model.curves[number] ?: model.complaint.failAt(surface.place, "there is no curve $number")
                outline.embed(listOf(piece(number, curve)))
            }
            if (outline.isEmpty) model.complaint.failAt(surface.place, "the surface ${surface.number} has no outline")
            NamedDomain(name, outline.toDomain())
        }
    }

    /** The curves of a loop from each to the next; as in Gmsh, their order and signs in the script need not be right. */
    private fun ordered(loop: GeoModel.Loop): List<OutlinePiece> {
        val rest = loop.curves.map { number ->
            val curve = model.curves[Math.abs(number)] ?: model.complaint.failAt(loop.place, "there is no curve $number")
            Directed(curve, piece(Math.abs(number), curve), number < 0)
        }.toMutableList()
        if (rest.isEmpty()) model.complaint.failAt(loop.place, "the loop is empty")
        val first = rest.removeFirst()
        val pieces = arrayListOf(first.piece())
        var end = first.end
        while (rest.isNotEmpty()) {
            val at = rest.indexOfFirst { same(it.begin, end) }.let { if (it >= 0) it else rest.indexOfFirst { c -> same(c.end, end) } }
            if (at < 0) model.complaint.failAt(loop.place, "the loop is not closed: nothing goes on from (${end.x}, ${end.y})")
            var next = rest.removeAt(at)
            if (!same(next.begin, end)) next = next.turned()
            pieces.add(next.piece())
            end = next.end
        }
        if (!same(end, first.begin)) model.complaint.failAt(loop.place, "the loop is not closed: it ends at (${end.x}, ${end.y})")
        return pieces
    }

    private fun same(a: GeoModel.Point, b: GeoModel.Point) = a === b || a.x == b.x && a.y == b.y

    private fun piece(number: Int, curve: GeoModel.Curve): OutlinePiece =
        OutlinePiece(curve.curve, model.curveTags[number] ?: DEFAULT_TAG, model.divisions[number] ?: divisionBySizes(curve))

    /**
     * Between sizes a and b at the ends of a length l, sizes run linearly: the integral of 1 / h is l ln(b / a) / (b - a) intervals,
     * their lengths in geometric progression from a to b.
     */
    private fun divisionBySizes(curve: GeoModel.Curve): OutlineDivision? {
        val a = if (curve.begin.size.isNaN()) curve.end.size else curve.begin.size
        val b = if (curve.end.size.isNaN()) curve.begin.size else curve.end.size
        if (a.isNaN()) return null
        val length = PieceDivision.length(curve.curve)
        val wanted = if (Math.abs(b - a) < NEARLY * a) length / a else length * StrictMath.log(b / a) / (b - a)
        if (!(wanted < MOST)) model.complaint.fail("the sizes $a and $b ask for too many nodes on a length of $length")
        return OutlineDivision(Math.max(least(curve.curve), Math.round(wanted).toInt()), b / a)
    }

    /** Parts of a curve however large the sizes are, as Gmsh has them: six of a circle, two of a spline. */
    private fun least(curve: PlaneCurve): Int = when (curve) {
        is StraightLine -> 1
        is EllipseArc -> Math.max(1, (0.99 + 6 * curve.share).toInt())
        else -> 2
    }

    private class Directed(val curve: GeoModel.Curve, private val own: OutlinePiece, private val isReversed: Boolean) {
        val begin: GeoModel.Point get() = if (isReversed) curve.end else curve.begin
        val end: GeoModel.Point get() = if (isReversed) curve.begin else curve.end

        fun turned() = Directed(curve, own, !isReversed)

        fun piece(): OutlinePiece = if (isReversed) own.reversed() else own
    }

    private companion object {
        const val DEFAULT_TAG = "boundary"
        const val NEARLY = 1e-9
        const val MOST = 1e6
    }
}
