package org.trigrid.front

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.domain.LaidDomain
import org.trigrid.geometry.IntList

/**
 * Tells [listener] of the elements of a domain as it is laid, in the numbers and places of the [given] one: at once, or for a
 * domain in a frame when it is sure that the mesh made in it is good.
 */
internal class LaidListener(private val laid: LaidDomain, private val given: Domain, private val listener: FrontListener) :
    FrontListener {
    private val nodes = IntList()
    private var xy = DoubleArray(0)

    override fun elementMade(a: Int, b: Int, c: Int, x: Double, y: Double) {
        if (laid.pose.frame == null) tell(a, b, c, x, y) else note(a, b, c, x, y)
    }

    /** Tells what was kept back. */
    fun tellAll(checkpoint: Checkpoint) {
        for (i in 0 until nodes.size / 3) {
            checkpoint.pass()
            tell(nodes[3 * i], nodes[3 * i + 1], nodes[3 * i + 2], xy[2 * i], xy[2 * i + 1])
        }
        nodes.clear()
    }

    private fun note(a: Int, b: Int, c: Int, x: Double, y: Double) {
        val i = nodes.size / 3
        if (2 * i + 1 >= xy.size) xy = xy.copyOf(2 * xy.size + 64)
        xy[2 * i] = x
        xy[2 * i + 1] = y
        nodes.add(a)
        nodes.add(b)
        nodes.add(c)
    }

    private fun tell(a: Int, b: Int, c: Int, x: Double, y: Double) {
        val pose = laid.pose
        val from = laid.givenNode(if (pose.isMirrored) b else a)
        val to = laid.givenNode(if (pose.isMirrored) a else b)
        val apex = laid.givenNode(c)
        if (apex < given.nodeCount) {
            listener.elementMade(from, to, apex, given.x(apex), given.y(apex))
        } else {
            listener.elementMade(from, to, apex, pose.givenX(x, y), pose.givenY(x, y))
        }
    }
}
