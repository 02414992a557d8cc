package org.trigrid.front

import org.trigrid.quality.TriangleQuality

/**
 * Advances the front by the size field. For each base edge, the candidates are its two neighbours, the front nodes
 * near the ideal place, and a new node there; the best-shaped one that is clear of the front makes the element.
 *
 * Source: Lo (1985), IJNME 21:1403-1426; Peraire et al. (1987), J. Comput. Phys. 72:449-466. Departures: placement by
 * an explicit size field, candidates ranked by shape with a preference for nodes that exist, escalation per edge.
 */
internal class RobustAdvancer private constructor(state: FrontState, private val keys: FrontKeys, ticker: FrontTicker) :
    FrontAdvancer(state, keys.keyCount, ticker) {
    constructor(state: FrontState, ticker: FrontTicker) : this(state, FrontKeys(state.mesh, state.front), ticker)

    private val candidates = CandidateList()
    private var ax = 0.0
    private var ay = 0.0
    private var bx = 0.0
    private var by = 0.0
    private var px = 0.0
    private var py = 0.0
    private var size = 0.0
    private var reach = 0.0

    override fun keyOf(edge: Int): Int = keys.keyOf(edge)

    override fun requeueAround(edge: Int) {
        val before = front.previous[edge]
        val after = front.next[edge]
        val angleBefore = keys.angleAt(before)
        val angle = keys.angleAt(edge)
        val angleAfter = keys.angleAt(after)
        val angleBeyond = keys.angleAt(front.next[after])
        queue.put(edge, keys.keyOf(edge, angle, angleAfter))
        queue.put(before, keys.keyOf(before, angleBefore, angle))
        queue.put(after, keys.keyOf(after, angleAfter, angleBeyond))
    }

    override fun tryEdge(edge: Int): Boolean {
        acceptance.base(edge)
        val fails = front.fails[edge].toInt()
        if (fails >= FrontKeys.MAX_FAILS) {
            takeVisibleNode(edge)
            return true
        }
        if (fails == 0 && closeEar(edge)) return true
        placeIdeal(edge)
        reach = REACH * size * (if (fails == 0) 1.0 else WIDER)
        queryNear()
        collect(edge, fails)
        val leastQuality = if (fails == 0) LEAST_QUALITY else LEAST_QUALITY_LATER
        while (true) {
            val best = candidates.takeBest()
            if (best == CandidateList.EMPTY) return false
            if (best == CandidateList.NEW_NODE) {
                if (!isPlaceClear()) continue
                addNode(edge, px, py)
                return true
            }
            if (isCornerClear(best, leastQuality)) {
                join(edge, best)
                return true
            }
        }
    }

    /**
     * Closes the corner at one end of the edge where that makes a nearly equilateral element, and returns true: no other
     * candidate would be better by a margin, so neither the size nor what is near need be known.
     */
    private fun closeEar(edge: Int): Boolean {
        val a = front.origin[edge]
        val b = front.destination(edge)
        val ahead = front.next[front.next[edge]]
        val behind = front.previous[edge]
        val atEnd = quality(a, b, front.origin[ahead])
        val atStart = quality(a, b, front.origin[behind])
        val best = Math.max(atEnd, atStart)
        if (best < EAR_QUALITY) return false
        val corner = if (atEnd >= atStart) ahead else behind
        val q = front.origin[corner]
        if (!acceptance.isLeftOfBase(mesh.xy[2 * q], mesh.xy[2 * q + 1]) || !acceptance.seesBase(corner)) return false
        if (!acceptance.isClear(q, mesh.xy[2 * q], mesh.xy[2 * q + 1])) return false
        join(edge, corner)
        return true
    }

    private fun quality(a: Int, b: Int, c: Int): Double {
        val xy = mesh.xy
        return TriangleQuality.shape(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1])
    }

    /** Sets the ideal place: the apex of the isosceles triangle whose sides have the wanted size. */
    private fun placeIdeal(edge: Int) {
        val a = front.origin[edge]
        val b = front.destination(edge)
        val xy = mesh.xy
        ax = xy[2 * a]
        ay = xy[2 * a + 1]
        bx = xy[2 * b]
        by = xy[2 * b + 1]
        val dx = bx - ax
        val dy = by - ay
        val length2 = dx * dx + dy * dy
        val length = Math.sqrt(length2)
        val mx = 0.5 * (ax + bx)
        val my = 0.5 * (ay + by)
        val wanted = state.sizeNear(a, mx - SAMPLE_HEIGHT * dy, my + SAMPLE_HEIGHT * dx)
        size = Math.min(Math.max(wanted, SHORTEST_SIDE * length), LONGEST_SIDE * length)
        // Of the height over the base edge's length.
        val slenderness = Math.max(FLATTEST, Math.sqrt(Math.max(0.0, size * size / length2 - 0.25)))
        px = mx - slenderness * dy
        py = my + slenderness * dx
        leanToCorner(edge, length, length2)
    }

    /**
     * Where one end of the base edge is a corner of about 90 degrees, moves the ideal place to the bisector, as the
     * paper's case B: two good elements there instead of one that cuts the corner off.
     */
    private fun leanToCorner(edge: Int, length: Double, length2: Double) {
        val ahead = front.origin[front.next[front.next[edge]]]
        val behind = front.origin[front.previous[edge]]
        val atEnd = isHalved(ahead, bx, by, ax, ay, length2)
        val atStart = isHalved(behind, ax, ay, bx, by, length2)
        if (atEnd == atStart) return
        if (atEnd) placeOnBisector(ahead, bx, by, ax, ay, length) else placeOnBisector(behind, ax, ay, bx, by, length)
    }

    /** Whether the angle at the end v of the base edge v-w, towards the next front node q, is to be halved. */
    private fun isHalved(q: Int, vx: Double, vy: Double, wx: Double, wy: Double, length2: Double): Boolean {
        val qx = mesh.xy[2 * q]
        val qy = mesh.xy[2 * q + 1]
        val tx = qx - vx
        val ty = qy - vy
        val other2 = tx * tx + ty * ty
        // Squares and sums of signs: no root, no quotient, no branch that could not be foreseen.
        val dot = (wx - vx) * tx + (wy - vy) * ty
        val limit = if (dot < 0) WIDEST_HALVED * WIDEST_HALVED else SHARP_EAR * SHARP_EAR
        val unlike = signs(UNLIKE * UNLIKE * length2 - other2) or signs(UNLIKE * UNLIKE * other2 - length2)
        val outside = signs(limit * length2 * other2 - dot * dot)
        return (unlike or outside) >= 0 && (bx - ax) * (qy - ay) - (by - ay) * (qx - ax) > 0
    }

    private fun placeOnBisector(q: Int, vx: Double, vy: Double, wx: Double, wy: Double, length: Double) {
        val tx = mesh.xy[2 * q] - vx
        val ty = mesh.xy[2 * q + 1] - vy
        val other = Math.sqrt(tx * tx + ty * ty)
        val ux = (wx - vx) / length + tx / other
        val uy = (wy - vy) / length + ty / other
        val norm = Math.sqrt(ux * ux + uy * uy)
        px = vx + size * ux / norm
        py = vy + size * uy / norm
    }

    private fun queryNear() = index.query(
        Math.min(Math.min(ax, bx), px - reach), Math.min(Math.min(ay, by), py - reach),
        Math.max(Math.max(ax, bx), px + reach), Math.max(Math.max(ay, by), py + reach),
    )

    private fun collect(edge: Int, fails: Int) {
        candidates.clear()
        val a = front.origin[edge]
        val b = front.destination(edge)
        val ahead = front.next[front.next[edge]]
        val behind = front.previous[edge]
        val near2 = NEAR_PLACE * NEAR_PLACE * size * size
        val nodeClearance2 = NODE_CLEARANCE * NODE_CLEARANCE * size * size
        val edgeClearance2 = EDGE_CLEARANCE * EDGE_CLEARANCE * size * size
        val reach2 = reach * reach
        val xy = mesh.xy
        // The sign tells whether something is too near to the ideal place; no branch, as none could be foreseen.
        var inTheWay = 0L
        for (i in 0 until index.foundCount) {
            val corner = index.found[i]
            val q = front.origin[corner]
            val v = front.destination(corner)
            val qx = xy[2 * q]
            val qy = xy[2 * q + 1]
            val ex = px - qx
            val ey = py - qy
            val d2 = ex * ex + ey * ey
            val dx = xy[2 * v] - qx
            val dy = xy[2 * v + 1] - qy
            val along = ex * dx + ey * dy
            val length2 = dx * dx + dy * dy
            val across = ex * dy - ey * dx
            val besideEdge = signs(-along) and signs(along - length2) and signs(across * across - edgeClearance2 * length2)
            inTheWay = inTheWay or if (corner == edge) 0 else signs(d2 - nodeClearance2) or besideEdge
            if ((d2 > reach2) or (corner == edge) or (corner == ahead) or (corner == behind) or (q == a) or (q == b)) continue
            addCorner(corner, qx, qy, if (d2 < near2) PREFERENCE else FAR_FACTOR)
        }
        val free = inTheWay >= 0 && mesh.nodeCount < state.nodeBudget
        collectEar(ahead, bx, by, ax, ay, near2, fails)
        if (behind != ahead) collectEar(behind, ax, ay, bx, by, near2, fails)
        if (free) candidates.add(CandidateList.NEW_NODE, NEW_NODE_FACTOR * TriangleQuality.shape(ax, ay, bx, by, px, py))
    }

    private fun addCorner(corner: Int, qx: Double, qy: Double, factor: Double) {
        val quality = TriangleQuality.shape(ax, ay, bx, by, qx, qy)
        if (quality > 0) candidates.add(corner, factor * quality)
    }

    /** The neighbour of the base edge at its end v; w is the other end. */
    private fun collectEar(corner: Int, vx: Double, vy: Double, wx: Double, wy: Double, near2: Double, fails: Int) {
        val q = front.origin[corner]
        val qx = mesh.xy[2 * q]
        val qy = mesh.xy[2 * q + 1]
        val ux = wx - vx
        val uy = wy - vy
        val tx = qx - vx
        val ty = qy - vy
        val dot = ux * tx + uy * ty
        val lengths2 = (ux * ux + uy * uy) * (tx * tx + ty * ty)
        if (fails == 0 && !isAbove(dot, WIDEST_EAR, lengths2)) return
        val d2 = (qx - px) * (qx - px) + (qy - py) * (qy - py)
        addCorner(corner, qx, qy, if (isAbove(dot, SHARP_EAR, lengths2) || d2 < near2) PREFERENCE else 1.0)
    }

    /** Whether the cosine of the angle between two sides is above a positive one, told by their dot and squares' product. */
    private fun isAbove(dot: Double, cosine: Double, lengths2: Double): Boolean = dot > 0 && dot * dot > cosine * cosine * lengths2

    private fun isPlaceClear(): Boolean =
        acceptance.isLeftOfBase(px, py) && acceptance.isClear(-1, px, py, index.found, index.foundCount)

    private fun isCornerClear(corner: Int, leastQuality: Double): Boolean {
        val q = front.origin[corner]
        val qx = mesh.xy[2 * q]
        val qy = mesh.xy[2 * q + 1]
        if (TriangleQuality.shape(ax, ay, bx, by, qx, qy) < leastQuality) return false
        if (!acceptance.isLeftOfBase(qx, qy) || !acceptance.seesBase(corner)) return false
        if (Math.abs(qx - px) <= reach && Math.abs(qy - py) <= reach) {
            return acceptance.isClear(q, qx, qy, index.found, index.foundCount)
        }
        // A neighbour at the end of a long edge: what was found does not cover its triangle.
        val clear = acceptance.isClear(q, qx, qy)
        if (!clear) queryNear()
        return clear
    }

    /** Negative if [value] is. */
    private fun signs(value: Double): Long = java.lang.Double.doubleToRawLongBits(value)

    private companion object {
        /** Height over the base edge, in its length, at which the wanted size is asked. */
        const val SAMPLE_HEIGHT = 0.6

        /** Bounds of the new sides, in the base edge's length. */
        const val SHORTEST_SIDE = 0.55
        const val LONGEST_SIDE = 2.0

        /** Least height of the ideal place, in the base edge's length. */
        const val FLATTEST = 0.2

        /** How far from the ideal place nodes are looked for, in the wanted size, and how much farther later. */
        const val REACH = 0.85
        const val WIDER = 3.0

        /** A new node keeps these distances from front nodes and edges, in the wanted size. */
        const val NODE_CLEARANCE = 0.62
        const val EDGE_CLEARANCE = 0.4

        /** Existing nodes are worth more where they lie this near to the ideal place, or close a sharp angle. */
        const val PREFERENCE = 1.15
        const val NEAR_PLACE = 0.62

        /**
         * And less where they lie farther off: a strip of one and a half rows is better cut into two rows than
         * spanned by one, since both are off by a factor of the square root of two.
         */
        const val FAR_FACTOR = 0.83

        /** A new node must be this much better than an existing one to be made. */
        const val NEW_NODE_FACTOR = 0.78

        /** Cosines of about 87 and 80 degrees: neighbours are left alone above the first, preferred below the second. */
        const val WIDEST_EAR = 0.05
        const val SHARP_EAR = 0.17

        /** Cosine of 120 degrees: angles from [SHARP_EAR] to this one are halved, if their sides are about as long. */
        const val WIDEST_HALVED = -0.5
        const val UNLIKE = 1.6

        /** From here on a corner is closed without looking at other candidates. */
        const val EAR_QUALITY = 0.92

        const val LEAST_QUALITY = 0.25
        const val LEAST_QUALITY_LATER = 0.02
    }
}
