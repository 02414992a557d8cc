package org.trigrid.spacing

import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.Envelope
import org.locationtech.jts.index.strtree.ItemDistance
import org.locationtech.jts.index.strtree.STRtree
import org.trigrid.diagnostics.Checkpoint
import org.trigrid.domain.Domain
import org.trigrid.geometry.IntList

/**
 * A field with the sizes that embedded points need. A point takes the size that the field has there, but where another given node
 * is nearer to it than that, no element of this size fits in between: then the distance is its size, which grows from there by
 * the gradation.
 */
internal class PointField private constructor(
    private val plain: SizeField,
    private val close: ConeTree,
    private val minSize: Double,
    override val detail: Double,
) : SizeField {
    override val lastHint: Int get() = plain.lastHint

    override fun hintOf(node: Int): Int = plain.hintOf(node)

    override fun sizeAt(x: Double, y: Double, hint: Int): Double {
        val size = plain.sizeAt(x, y, hint)
        return Math.min(size, Math.max(minSize, close.min(x, y, close.winner, size)))
    }

    companion object {
        private val DISTANCE = ItemDistance { a, b -> (a.item as Coordinate).distance(b.item as Coordinate) }

        /** [field] itself where no point is near another node. */
        fun over(field: SizeField, domain: Domain, rules: SizeRules, checkpoint: Checkpoint): SizeField {
            if (domain.segmentNodeCount == domain.nodeCount) return field
            val distances = distances(domain, checkpoint)
            val close = IntList()
            for (node in domain.segmentNodeCount until domain.nodeCount) {
                checkpoint.pass()
                if (distances[node - domain.segmentNodeCount] < field.sizeAt(domain.x(node), domain.y(node), -1)) close.add(node)
            }
            if (close.size == 0) return field
            val xy = DoubleArray(2 * close.size) { domain.xy[2 * close[it / 2] + it % 2] }
            val sizes = DoubleArray(close.size) { distances[close[it] - domain.segmentNodeCount] }
            val box = Envelope()
            for (node in 0 until domain.nodeCount) box.expandToInclude(domain.x(node), domain.y(node))
            val detail = Math.min(field.detail, Math.max(box.width, box.height) / CELLS)
            return PointField(field, ConeTree(xy, sizes, rules.gradation, checkpoint), rules.minSize, detail)
        }

        /** Of each embedded point from the nearest other node. */
        private fun distances(domain: Domain, checkpoint: Checkpoint): DoubleArray {
            val tree = STRtree()
            for (node in 0 until domain.nodeCount) {
                val place = Coordinate(domain.x(node), domain.y(node))
                tree.insert(Envelope(place), place)
            }
            return DoubleArray(domain.nodeCount - domain.segmentNodeCount) {
                checkpoint.pass()
                val node = domain.segmentNodeCount + it
                val place = Coordinate(domain.x(node), domain.y(node))
                tree.nearestNeighbour(Envelope(place), place, DISTANCE, 2).maxOf { other -> (other as Coordinate).distance(place) }
            }
        }

        /** Parts of the domain's width in which points are looked for when elements are counted. */
        private const val CELLS = 64
    }
}
