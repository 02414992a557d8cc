package org.trigrid.domain

/** Finds sharp angles, jumps of the spacing and narrow gaps of a domain; none where segments have no length. */
internal class WarningSearch(private val checked: CheckedDomain) {
    private val domain = checked.domain
    private val xy = checked.xy
    private val warnings = ArrayList<DomainWarning>()

    fun find(): List<DomainWarning> {
        if (checked.tested.size != domain.segmentCount) return emptyList()
        for (loop in 0 until domain.loopCount) examineCorners(domain.loopStart(loop), domain.loopStart(loop + 1))
        for (gap in GapSearch(checked).find()) add(gap)
        return warnings
    }

    private fun examineCorners(from: Int, to: Int) {
        for (s in from until to) {
            val next = if (s + 1 < to) s + 1 else from
            val node = domain.segmentEnd(s)
            if (domain.segmentStart(next) != node) continue
            val angle = angle(node, domain.segmentEnd(next), domain.segmentStart(s))
            if (angle < SHARPEST_DEGREES) {
                add(WarningKind.SHARP_ANGLE, node, "the angle at node ${checked.nodeText(node)} is ${rounded(angle)} degrees")
            }
            val ratio = length(next) / length(s)
            if (ratio > LARGEST_RATIO || ratio < 1 / LARGEST_RATIO) {
                val times = "by a factor of ${rounded(Math.max(ratio, 1 / ratio))}"
                add(WarningKind.SPACING_JUMP, node, "segments at node ${checked.nodeText(node)} differ in length $times")
            }
        }
    }

    /** Degrees, 0 until 360, anticlockwise at [node] from the direction of [out] to that of [back]. */
    private fun angle(node: Int, out: Int, back: Int): Double {
        val ux = xy[2 * out] - xy[2 * node]
        val uy = xy[2 * out + 1] - xy[2 * node + 1]
        val vx = xy[2 * back] - xy[2 * node]
        val vy = xy[2 * back + 1] - xy[2 * node + 1]
        val turn = StrictMath.toDegrees(StrictMath.atan2(ux * vy - uy * vx, ux * vx + uy * vy))
        return if (turn < 0) turn + 360 else turn
    }

    private fun length(s: Int): Double {
        val a = domain.segmentStart(s)
        val b = domain.segmentEnd(s)
        return Math.hypot(xy[2 * b] - xy[2 * a], xy[2 * b + 1] - xy[2 * a + 1])
    }

    private fun add(gap: GapSearch.Gap) {
        val between = if (gap.sameLoop) "the boundary" else "another loop"
        val kind = if (gap.sameLoop) WarningKind.NARROW_GAP else WarningKind.CLOSE_LOOPS
        val t = gap.segment
        val text = "node ${checked.nodeText(gap.node)} is ${gap.width} from segment ${checked.segmentText(t)} of $between, " +
            "${rounded(gap.share)} of its length"
        add(kind, intArrayOf(gap.node, checked.nodeAtStart(t), checked.nodeAtEnd(t)), text)
    }

    private fun add(kind: WarningKind, node: Int, message: String) = add(kind, intArrayOf(node), message)

    private fun add(kind: WarningKind, nodes: IntArray, message: String) {
        warnings.add(DomainWarning(kind, message, xy[2 * nodes[0]], xy[2 * nodes[0] + 1], nodes))
    }

    private fun rounded(value: Double): Double = Math.rint(value * 1000) / 1000

    private companion object {
        const val SHARPEST_DEGREES = 5.0
        const val LARGEST_RATIO = 3.0
    }
}
