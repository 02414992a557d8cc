package org.trigrid.spacing

import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.mesh.RegionFlood
import org.trigrid.mesh.TaggedSides

/** The largest sizes of a domain's regions, by place. */
internal class RegionSizes(domain: Domain, mesh: ConstrainedDelaunay, checkpoint: Checkpoint) {
    private val walk = TriangleWalk(mesh, checkpoint)
    private val ofTriangle: DoubleArray
    private val ofNode = DoubleArray(domain.nodeCount) { Double.POSITIVE_INFINITY }
    private var last = 0

    init {
        val most = domain.regions.map { it.maxSize }
        val neighbours = IntArray(mesh.twins.size) { if (mesh.twins[it] < 0) -1 else mesh.twins[it] / 3 }
        val sides = TaggedSides(domain.nodeCount, mesh.nodes, 3, domain.segments, 2)
        checkpoint.ask()
        val regions = RegionFlood(neighbours, sides, domain.segmentCount).regions(domain::regionOnLeft, domain::regionOnRight)
        checkpoint.ask()
        ofTriangle = DoubleArray(regions.size) { most[regions[it]] }
        for (s in 0 until domain.segmentCount) {
            val right = domain.regionOnRight(s)
            val least = Math.min(most[domain.regionOnLeft(s)], if (right < 0) Double.POSITIVE_INFINITY else most[right])
            for (node in intArrayOf(domain.segmentStart(s), domain.segmentEnd(s))) ofNode[node] = Math.min(ofNode[node], least)
        }
    }

    /** @param near a triangle near the place, or -1. */
    fun at(x: Double, y: Double, near: Int): Double {
        last = walk.find(x, y, if (near >= 0) near else last)
        return ofTriangle[last]
    }

    /** The least of the regions that meet in a node. */
    fun atNode(node: Int): Double = ofNode[node]

    companion object {
        /** Null where no region has a largest size. */
        fun of(domain: Domain, mesh: ConstrainedDelaunay, checkpoint: Checkpoint): RegionSizes? =
            if (domain.regions.all { it.maxSize == Double.POSITIVE_INFINITY }) null else RegionSizes(domain, mesh, checkpoint)
    }
}
