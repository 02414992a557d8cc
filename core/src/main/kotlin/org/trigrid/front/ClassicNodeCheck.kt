package org.trigrid.front

import org.locationtech.jts.algorithm.LineIntersector
import org.locationtech.jts.algorithm.RobustLineIntersector
import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator
import org.locationtech.jts.geom.Coordinate
import org.locationtech.jts.geom.GeometryFactory
import org.locationtech.jts.geom.Location
import org.locationtech.jts.geom.Polygon
import org.trigrid.domain.Domain
import java.util.BitSet

/**
 * The paper's checks of a new node: not outside the boundary, not close to an existing node, and its two sides
 * crossing nothing. Inside or outside and crossings are told by JTS; the exact tests of [Acceptance] come after them.
 */
internal class ClassicNodeCheck(domain: Domain, private val state: FrontState) {
    private val mesh = state.mesh
    private val front = state.front
    private val index = state.index
    private val acceptance = state.acceptance
    private val inside = IndexedPointInAreaLocator(loopsOf(domain))
    private val intersector: LineIntersector = RobustLineIntersector()
    private val p = Coordinate()
    private val q = Coordinate()
    private val u = Coordinate()
    private val v = Coordinate()

    /** Whether a node at ([x], [y]), its new sides about [s] long, may make an element over [base]. */
    fun isFree(base: Int, x: Double, y: Double, s: Double): Boolean {
        if (mesh.nodeCount >= state.nodeBudget) return false
        p.x = x
        p.y = y
        if (inside.locate(p) != Location.INTERIOR) return false
        acceptance.base(base)
        if (!acceptance.isLeftOfBase(x, y)) return false
        index.query(x - 2 * s, y - 2 * s, x + 2 * s, y + 2 * s)
        if (isCloseToFront(x, y, CLEARANCE * s)) return false
        if (crosses(front.origin[base]) || crosses(front.destination(base))) return false
        return acceptance.isClear(-1, x, y)
    }

    private fun isCloseToFront(x: Double, y: Double, clearance: Double): Boolean {
        for (i in 0 until index.foundCount) {
            val node = front.origin[index.found[i]]
            if (Math.hypot(mesh.xy[2 * node] - x, mesh.xy[2 * node + 1] - y) < clearance) return true
        }
        return false
    }

    /** Whether the side from the new node to [node] meets a front edge that does not end there. */
    private fun crosses(node: Int): Boolean {
        set(q, node)
        for (i in 0 until index.foundCount) {
            val edge = index.found[i]
            val from = front.origin[edge]
            val to = front.destination(edge)
            if (from == node || to == node) continue
            set(u, from)
            set(v, to)
            intersector.computeIntersection(p, q, u, v)
            if (intersector.hasIntersection()) return true
        }
        return false
    }

    private fun set(coordinate: Coordinate, node: Int) {
        coordinate.x = mesh.xy[2 * node]
        coordinate.y = mesh.xy[2 * node + 1]
    }

    /** Every loop as a polygon of its own: a place is inside the domain where it is inside an odd number of them. */
    private fun loopsOf(domain: Domain): org.locationtech.jts.geom.MultiPolygon {
        val factory = GeometryFactory()
        val seen = BitSet(front.idBound)
        val polygons = ArrayList<Polygon>()
        for (start in 0 until front.idBound) {
            if (seen[start]) continue
            val ring = ArrayList<Coordinate>()
            var edge = start
            do {
                seen.set(edge)
                val node = front.origin[edge]
                ring.add(Coordinate(domain.x(node), domain.y(node)))
                edge = front.next[edge]
            } while (edge != start)
            ring.add(ring[0])
            // A loop of two edges is an embedded line; it bounds nothing.
            if (ring.size > 3) polygons.add(factory.createPolygon(ring.toTypedArray()))
        }
        return factory.createMultiPolygon(polygons.toTypedArray())
    }

    private companion object {
        /** New nodes keep this distance from front nodes, in the length of their sides. */
        const val CLEARANCE = 0.6
    }
}
