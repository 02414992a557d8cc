package org.trigrid.front

import org.trigrid.domain.LaidDomain

/** Tells [listener] of the elements of a domain as it is laid, in the numbers and places of the given one. */
internal class LaidListener(private val laid: LaidDomain, private val listener: FrontListener) : FrontListener {
    override fun elementMade(a: Int, b: Int, c: Int, x: Double, y: Double) {
        val pose = laid.pose
        val from = laid.givenNode(if (pose.isMirrored) b else a)
        val to = laid.givenNode(if (pose.isMirrored) a else b)
        listener.elementMade(from, to, laid.givenNode(c), pose.givenX(x, y), pose.givenY(x, y))
    }
}
