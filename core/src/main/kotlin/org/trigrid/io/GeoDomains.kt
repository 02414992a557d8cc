package org.trigrid.io

import org.trigrid.domain.Domain
import org.trigrid.domain.Region

/** Makes a domain of the plane surfaces of a `.geo` script: its regions, where there are several. */
internal class GeoDomains(private val model: GeoModel, private val input: DomainText) {
    /** Curves with their nodes, which surfaces on both sides share. */
    private val pieces = HashMap<Int, OutlinePiece>()

    fun domains(): List<NamedDomain> {
        if (model.surfaces.isEmpty()) model.complaint.fail("there is no Plane Surface in it")
        val single = model.surfaces.singleOrNull()
        if (single != null) {
            val region = model.regions[single.number] ?: Region.of(input.baseName)
            return listOf(NamedDomain(region.name, domain(single, region)))
        }
        val builder = Domain.builder()
        for (surface in model.surfaces) {
            val region = model.regions[surface.number] ?: Region.of("surface ${surface.number}")
            try {
                builder.add(domain(surface, region))
            } catch (e: IllegalArgumentException) {
                model.complaint.failAt(surface.place, e.message.orEmpty())
            }
        }
        return listOf(NamedDomain(input.baseName, builder.regionName(UNUSED).build()))
    }

    private fun domain(surface: GeoModel.Surface, region: Region): Domain {
        val outline = Outline(input, region)
        surface.loops.forEachIndexed { i, number ->
            val loop = model.loops[Math.abs(number)] ?: model.complaint.failAt(surface.place, "there is no loop $number")
            val pieces = ordered(loop)
            if (i == 0) outline.outer(pieces) else outline.hole(pieces)
        }
        for (number in model.inner[surface.number].orEmpty()) {
            val curve = model.curves[number] ?: model.complaint.failAt(surface.place, "there is no curve $number")
            outline.embed(listOf(piece(number, curve)))
        }
        for (number in model.innerPoints[surface.number].orEmpty()) {
            val point = model.points[number] ?: model.complaint.failAt(surface.place, "there is no point $number")
            outline.embedPoint(point.x, point.y, model.pointTags[number] ?: "point $number")
        }
        if (outline.isEmpty) model.complaint.failAt(surface.place, "the surface ${surface.number} has no outline")
        return outline.toDomain()
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

    private fun piece(number: Int, curve: GeoModel.Curve): OutlinePiece = pieces.getOrPut(number) {
        val tag = model.curveTags[number] ?: DEFAULT_TAG
        val piece = OutlinePiece(curve.curve, tag, model.divisions[number] ?: divisionBySizes(curve))
        val nodes = PieceDivision.points(piece, input.spacing, input.ratio, curve.begin === curve.end)
        OutlinePiece(curve.curve, tag, piece.division, nodes)
    }

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

        /** Of what is no surface, which there is none of. */
        const val UNUSED = "domain"
        const val NEARLY = 1e-9
        const val MOST = 1e6
    }
}
