package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.Frame
import org.trigrid.geometry.Pose

/**
 * A domain laid in a way of its own: in one of eight poses, its loops in an order and from first nodes that depend on
 * its outline and not on how it was told; in a frame of its own too, where it can be.
 *
 * The front takes edges of like length and angle in the order in which it gets them, so a mesh depends on that order.
 * Meshed as it is laid here, an outline that is mirrored, turned, or given loop by loop in another order keeps its mesh:
 * to the bit for mirroring and quarter turns, and in a frame for other turns and for moves as well; without, up to rounding.
 */
internal class LaidDomain private constructor(
    /** The domain as it is laid, with node numbers of its own; tags as in the given one. */
    val domain: Domain,
    /** How it is laid. */
    val pose: Pose,
    /** Per node of [domain] its number in the given domain. */
    private val givenNodes: IntArray,
) {
    /** Number in the given domain; nodes that were not given keep their number. */
    fun givenNode(node: Int): Int = if (node < givenNodes.size) givenNodes[node] else node

    companion object {
        /** As it is given. */
        fun asGiven(domain: Domain): LaidDomain = LaidDomain(domain, Pose.AS_GIVEN, IntArray(domain.nodeCount) { it })

        /**
         * As its outline tells, in a frame of its own. The nodes are rounded to the frame's grid, so the laid domain may have
         * faults even though the [domain] is valid.
         */
        fun inFrame(domain: Domain, frame: Frame, checkpoint: Checkpoint): LaidDomain {
            val xy = DoubleArray(2 * domain.nodeCount)
            for (node in 0 until domain.nodeCount) {
                checkpoint.pass()
                xy[2 * node] = frame.x(domain.x(node), domain.y(node))
                xy[2 * node + 1] = frame.y(domain.x(node), domain.y(node))
            }
            val framed = Domain(
                xy, domain.segments, domain.segmentTags, domain.embedded, domain.tags, domain.regionMap, domain.points,
            )
            val laid = swept(framed, ExactPose(framed, frame.step, checkpoint).choose(), SWEEP, checkpoint)
            return LaidDomain(laid.domain, laid.pose.after(frame), laid.givenNodes)
        }

        /** As its outline tells, without a frame. The [domain] must be valid. */
        fun of(domain: Domain, checkpoint: Checkpoint): LaidDomain {
            val moments = NodeMoments(domain, checkpoint)
            val phase = if (moments.isMirrored) -moments.phase else moments.phase
            val turns = Math.floor((FIRST_PHASE - phase) / QUARTER).toInt() + 1
            val pose = Pose(moments.isMirrored, turns and 3)
            return swept(domain, pose, phase + (turns and 3) * QUARTER + SWEEP, checkpoint)
        }

        /** @param sweep angle of the sweep's direction in the domain as it is laid. */
        private fun swept(domain: Domain, pose: Pose, sweep: Double, checkpoint: Checkpoint): LaidDomain {
            val order = SweepOrder(domain, pose, StrictMath.cos(sweep), StrictMath.sin(sweep), checkpoint)
            val laid = Domain(order.xy(), order.segments, order.segmentTags, order.embedded, domain.tags, order.regions())
            return LaidDomain(laid, pose, order.givenNodes)
        }

        private const val QUARTER = Math.PI / 2

        /** The phase is brought into the quarter turn from here: an angle no outline is likely to have. */
        private const val FIRST_PHASE = 0.31

        /** Angle from the phase to the direction of the sweep, as unlikely to be met by a side of an outline. */
        private const val SWEEP = 0.83
    }
}
