package org.trigrid.editor.canvas

import org.trigrid.domain.Domain

/** The smallest upright rectangle round a domain's nodes. */
internal class Box(private val minX: Double, private val minY: Double, private val maxX: Double, private val maxY: Double) {
    val width: Double get() = maxX - minX
    val height: Double get() = maxY - minY
    val middleX: Double get() = minX + width / 2
    val middleY: Double get() = minY + height / 2

    companion object {
        /** The box of the nodes whose coordinates are numbers; a unit box where there are none. */
        fun of(domain: Domain): Box {
            val nodes = (0 until domain.nodeCount).filter { domain.x(it).isFinite() && domain.y(it).isFinite() }
            if (nodes.isEmpty()) return Box(0.0, 0.0, 1.0, 1.0)
            return Box(
                nodes.minOf { domain.x(it) },
                nodes.minOf { domain.y(it) },
                nodes.maxOf { domain.x(it) },
                nodes.maxOf { domain.y(it) },
            )
        }
    }
}
