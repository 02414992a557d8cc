package org.trigrid.spacing

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.Envelope
import org.locationtech.jts.index.strtree.ItemDistance
import org.locationtech.jts.index.strtree.STRtree
import org.trigrid.domain.Domain

/**
 * Sizes at embedded points. A point takes the size of the field, but where another given node is nearer to it than that, no
 * element of this size fits in between: then the distance is its size.
 */
internal object PointSources {
    private val DISTANCE = ItemDistance { a, b -> (a.item as Coordinate).distance(b.item as Coordinate) }

    /** A source at each such point. */
    fun of(domain: Domain, field: SizeField): SizeSources {
        if (domain.segmentNodeCount == domain.nodeCount) return SizeSources.NONE
        val tree = STRtree()
        for (node in 0 until domain.nodeCount) {
            val place = Coordinate(domain.x(node), domain.y(node))
            tree.insert(Envelope(place), place)
        }
        var sources = SizeSources.NONE
        for (node in domain.segmentNodeCount until domain.nodeCount) {
            val place = Coordinate(domain.x(node), domain.y(node))
            val nearest = tree.nearestNeighbour(Envelope(place), place, DISTANCE, 2)
            val distance = nearest.maxOf { (it as Coordinate).distance(place) }
            val size = field.sizeAt(place.x, place.y, -1)
            if (distance > 0 && distance < size) sources = sources.withPoint(distance, place.x, place.y)
        }
        return sources
    }
}
