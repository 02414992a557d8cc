package org.trigrid.front

import org.trigrid.mesh.MutableMesh

/**
 * The order in which base edges are taken: short ones first by octaves of their length, within these by layer,
 * within a layer by the smaller of the angles at the edge's ends. Refused edges come after all others.
 */
internal class FrontKeys(private val mesh: MutableMesh, private val front: Front) {
    private val lowest: Int
    private val classes: Int

    val keyCount: Int

    init {
        var low = Int.MAX_VALUE
        var high = Int.MIN_VALUE
        for (edge in 0 until front.idBound) {
            val c = lengthClass(edge)
            low = Math.min(low, c)
            high = Math.max(high, c)
        }
        lowest = low - 2
        classes = high - low + 5
        keyCount = (MAX_FAILS + 1) * classes * LAYERS * ANGLES
    }

    fun keyOf(edge: Int): Int = keyOf(edge, angleAt(edge), angleAt(front.next[edge]))

    /** As the other, with [angleAt] of the edge and of the next one. */
    fun keyOf(edge: Int, angleAtStart: Double, angleAtEnd: Double): Int {
        val c = Math.min(Math.max(lengthClass(edge) - lowest, 0), classes - 1)
        val layer = Math.min(front.layer[edge], LAYERS - 1)
        val angle = (Math.min(angleAtStart, angleAtEnd) * (ANGLES / 4.0) + ANGLE_NUDGE).toInt()
        val fails = Math.min(front.fails[edge].toInt(), MAX_FAILS)
        return ((fails * classes + c) * LAYERS + layer) * ANGLES + Math.min(angle, ANGLES - 1)
    }

    private fun lengthClass(edge: Int): Int {
        val xy = mesh.xy
        val a = 2 * front.origin[edge]
        val b = 2 * front.destination(edge)
        val dx = xy[b] - xy[a]
        val dy = xy[b + 1] - xy[a + 1]
        // Half of the squared length's exponent: scaling a domain by a power of two shifts all classes alike.
        return Math.getExponent(LENGTH_NUDGE * (dx * dx + dy * dy)) shr 1
    }

    /** Angle inside the domain at the origin of [edge], grown monotonically to 0..4 for 0..360 degrees. */
    fun angleAt(edge: Int): Double {
        val xy = mesh.xy
        val v = 2 * front.origin[edge]
        val w = 2 * front.destination(edge)
        val u = 2 * front.origin[front.previous[edge]]
        val ox = xy[w] - xy[v]
        val oy = xy[w + 1] - xy[v + 1]
        val ix = xy[u] - xy[v]
        val iy = xy[u + 1] - xy[v + 1]
        val dot = ox * ix + oy * iy
        val cross = ox * iy - oy * ix
        val r = dot / (Math.abs(dot) + Math.abs(cross))
        return if (cross >= 0 && u != w) 1 - r else 3 + r
    }

    companion object {
        private const val LAYERS = 512
        private const val ANGLES = 16

        // Right angles and lengths of a quarter are common: a little more, and rounding does not part those that are equal.
        private const val ANGLE_NUDGE = 1e-6
        private const val LENGTH_NUDGE = 1 + 1e-6

        /** An edge refused this often takes the way out. */
        const val MAX_FAILS = 2
    }
}
