package org.trigrid.domain

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.geometry.Pose

/**
 * Chooses one of the eight poses for a domain whose places are multiples of a [step], so that the domain laid in it is the same for
 * all that are each other's mirror images or turned by quarters.
 *
 * For each pose the laid nodes and segments are hashed to one number that does not depend on their order; the pose with the least
 * is chosen. Two poses have the same if the domain is the same in both. Coarse places are hashed first, as a place may have been
 * rounded otherwise in a domain that was turned.
 */
internal class ExactPose(private val domain: Domain, private val step: Double, private val checkpoint: Checkpoint) {
    private val nodeHashes = LongArray(domain.nodeCount)
    private val poses = List(8) { Pose(it >= 4, it and 3) }

    fun choose(): Pose {
        var left = poses
        for (unit in doubleArrayOf(COARSE * step, step)) {
            val hashes = left.map { hash(it, unit) }
            val least = hashes.min()
            left = left.filterIndexed { i, _ -> hashes[i] == least }
            if (left.size == 1) break
        }
        return left.first()
    }

    private fun hash(pose: Pose, unit: Double): Long {
        var sum = 0L
        for (node in nodeHashes.indices) {
            checkpoint.pass()
            val x = Math.rint(domain.x(node) / unit)
            val y = Math.rint(domain.y(node) / unit)
            nodeHashes[node] = mixed(pose.x(x, y).toLong() * FIRST_FACTOR + pose.y(x, y).toLong())
            sum += nodeHashes[node]
        }
        for (s in 0 until domain.segmentCount) {
            checkpoint.pass()
            val a = nodeHashes[domain.segmentStart(s)]
            val b = nodeHashes[domain.segmentEnd(s)]
            sum += when {
                domain.isEmbedded(s) -> mixed(a + b)
                pose.isMirrored -> mixed(FIRST_FACTOR * b + a)
                else -> mixed(FIRST_FACTOR * a + b)
            }
        }
        return sum
    }

    /** Each bit of the result depends on all of the value. */
    private fun mixed(value: Long): Long {
        val once = (value xor (value ushr 32)) * SECOND_FACTOR
        val twice = (once xor (once ushr 29)) * THIRD_FACTOR
        return twice xor (twice ushr 32)
    }

    private companion object {
        /** Some 2^14 steps, but no whole number of them, so that common places do not lie halfway between two. */
        const val COARSE = 17_859.7

        /** Odd numbers with bits of no pattern: the golden section's, and two of 64-bit primes. */
        const val FIRST_FACTOR = -7046029254386353131L
        const val SECOND_FACTOR = -4658895280553007687L
        const val THIRD_FACTOR = -7723592293110705685L
    }
}
