package org.trigrid.front

import org.trigrid.domain.Domain

/**
 * The paper's rules: start at the smallest angle on the front and, by its size, close it with one element (case A),
 * halve it with a new node and two elements (case B, eq. (1)), or put an equilateral element on the shorter of its
 * sides (case C); go on to the next smaller angle where a check fails; four nodes left are cut by a diagonal.
 *
 * Source: H. Naji, section 2, Figs. 5(a) to 5(d). Departures, all needed for the rules never to fail:
 * - every element is checked against the front, case A too, and the diagonal of four nodes as well;
 * - the length of eq. (1) is kept between 0.8 of the wanted size and twice the shorter side;
 * - when every angle has been refused, the smallest takes the constrained-Delaunay way out.
 *
 * An angle is known here by the front edge that leaves its node; angles that differ by less than 360 / [ANGLES]
 * degrees count as equal, the older first.
 */
internal class ClassicAdvancer(domain: Domain, state: FrontState, ticker: FrontTicker) :
    FrontAdvancer(state, 2 * ANGLES, ticker) {
    private val check = ClassicNodeCheck(domain, state)

    override fun keyOf(edge: Int): Int {
        val angle = Math.min((ANGLES * angleAt(edge) / FULL_TURN).toInt(), ANGLES - 1)
        return if (front.fails[edge] > 0) ANGLES + angle else angle
    }

    override fun tryEdge(edge: Int): Boolean {
        if (front.fails[edge] > 0) {
            acceptance.base(edge)
            takeVisibleNode(edge)
            return true
        }
        if (isQuadrilateral(edge)) return cutQuadrilateral(edge)
        val angle = angleAt(edge)
        return when {
            angle < CASE_B -> closeAngle(edge)
            angle <= CASE_C -> halveAngle(edge, angle)
            else -> putEquilateral(edge)
        }
    }

    /** Case A: the two sides of the angle and the line between their far ends. */
    private fun closeAngle(edge: Int): Boolean = tryEar(front.previous[edge])

    /** Element of [base] and the edge after it, if clear. */
    private fun tryEar(base: Int): Boolean {
        val apex = front.next[front.next[base]]
        if (!isElementClear(base, apex)) return false
        join(base, apex)
        return true
    }

    private fun isElementClear(base: Int, apex: Int): Boolean {
        acceptance.base(base)
        val q = front.origin[apex]
        val x = mesh.xy[2 * q]
        val y = mesh.xy[2 * q + 1]
        return acceptance.isLeftOfBase(x, y) && acceptance.isClear(q, x, y)
    }

    /** Case B: a node on the bisector at the distance of eq. (1), and an element on either side of it. */
    private fun halveAngle(edge: Int, angle: Double): Boolean {
        val before = front.previous[edge]
        val s1 = lengthOf(front.previous[before])
        val s2 = lengthOf(before)
        val s3 = lengthOf(edge)
        val s4 = lengthOf(front.next[edge])
        val wanted = (s1 + 2 * s2 + 2 * s3 + s4) / 6
        val v = front.origin[edge]
        val w = front.destination(edge)
        val xy = mesh.xy
        val ux = (xy[2 * w] - xy[2 * v]) / s3
        val uy = (xy[2 * w + 1] - xy[2 * v + 1]) / s3
        val cosine = StrictMath.cos(0.5 * angle)
        val sine = StrictMath.sin(0.5 * angle)
        val dx = ux * cosine - uy * sine
        val dy = ux * sine + uy * cosine
        val floor = LEAST_OF_SIZE * state.sizeNear(v, xy[2 * v] + wanted * dx, xy[2 * v + 1] + wanted * dy)
        val s = Math.min(Math.max(wanted, floor), MOST_OF_SIDE * Math.min(s2, s3))
        val x = xy[2 * v] + s * dx
        val y = xy[2 * v + 1] + s * dy
        if (!check.isFree(before, x, y, s) || !check.isFree(edge, x, y, s)) return false
        addNode(before, x, y)
        // The front now runs u -> P -> v -> w; the second element closes the angle at v.
        tryEar(front.previous[edge])
        return true
    }

    /** Case C: an equilateral element on the shorter side of the angle. */
    private fun putEquilateral(edge: Int): Boolean {
        val before = front.previous[edge]
        val base = if (lengthOf(before) < lengthOf(edge)) before else edge
        val a = front.origin[base]
        val b = front.destination(base)
        val xy = mesh.xy
        val dx = xy[2 * b] - xy[2 * a]
        val dy = xy[2 * b + 1] - xy[2 * a + 1]
        val x = xy[2 * a] + 0.5 * dx - HALF_ROOT_3 * dy
        val y = xy[2 * a + 1] + 0.5 * dy + HALF_ROOT_3 * dx
        if (!check.isFree(base, x, y, lengthOf(base))) return false
        addNode(base, x, y)
        return true
    }

    private fun isQuadrilateral(edge: Int): Boolean {
        val next = front.next
        val third = next[next[edge]]
        return third != edge && next[third] != edge && next[next[third]] == edge
    }

    /**
     * Fig. 5(d): nodes 1 to 4, the diagonal 1-3 if angles 2 and 4 add up to no more than 1 and 3, else 2-4. Where the
     * four are not convex only one diagonal lies inside, and where other loops lie inside perhaps none.
     */
    private fun cutQuadrilateral(first: Int): Boolean {
        val second = front.next[first]
        val third = front.next[second]
        val fourth = front.next[third]
        val through13 = angleAt(second) + angleAt(fourth) <= angleAt(first) + angleAt(third)
        return if (through13) cut(first) || cut(second) else cut(second) || cut(first)
    }

    /** Cuts from the start of [edge] to the node opposite: elements (1 2 3) and (1 3 4). */
    private fun cut(edge: Int): Boolean {
        val opposite = front.next[front.next[edge]]
        if (!isElementClear(opposite, edge) || !isElementClear(edge, opposite)) return false
        join(edge, opposite)
        tryEar(opposite)
        return true
    }

    private fun lengthOf(edge: Int): Double {
        val xy = mesh.xy
        val a = 2 * front.origin[edge]
        val b = 2 * front.destination(edge)
        return Math.hypot(xy[b] - xy[a], xy[b + 1] - xy[a + 1])
    }

    /** Angle inside the domain at the origin of [edge], radians, 0..2 pi. */
    private fun angleAt(edge: Int): Double {
        val xy = mesh.xy
        val v = 2 * front.origin[edge]
        val w = 2 * front.destination(edge)
        val u = 2 * front.origin[front.previous[edge]]
        if (u == w) return FULL_TURN
        val ox = xy[w] - xy[v]
        val oy = xy[w + 1] - xy[v + 1]
        val ix = xy[u] - xy[v]
        val iy = xy[u + 1] - xy[v + 1]
        val angle = StrictMath.atan2(ox * iy - oy * ix, ox * ix + oy * iy)
        return if (angle < 0) angle + FULL_TURN else angle
    }

    private companion object {
        const val FULL_TURN = 2 * Math.PI
        const val CASE_B = Math.PI / 2
        const val CASE_C = 5 * Math.PI / 6
        const val HALF_ROOT_3 = 0.8660254037844386
        const val ANGLES = 1 shl 15
        const val LEAST_OF_SIZE = 0.8
        const val MOST_OF_SIDE = 2.0
    }
}
