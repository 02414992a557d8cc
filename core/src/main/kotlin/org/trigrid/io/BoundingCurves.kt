package org.trigrid.io

import org.trigrid.mesh.TaggedSides

/** Which curve groups have an edge at the rim of which region. */
internal class BoundingCurves(mesh: FileMesh, groups: MeshGroups) {
    private val isAt = Array(groups.regionCount) { BooleanArray(groups.curveCount) }

    init {
        val left = TaggedSides(mesh.nodeCount, mesh.elements, mesh.nodesPerElement, mesh.edges, mesh.nodesPerEdge)
        val width = mesh.nodesPerEdge
        val turned = IntArray(mesh.edges.size) { if (it % width < 2) mesh.edges[it - it % width + 1 - it % width] else mesh.edges[it] }
        val right = TaggedSides(mesh.nodeCount, mesh.elements, mesh.nodesPerElement, turned, width)
        for (curve in 0 until groups.curveCount) {
            for (k in 0 until groups.size(curve)) {
                val edge = groups.edge(curve, k)
                val here = mesh.regionOf(left.leftOf(edge) / 3)
                if (edge < mesh.boundaryEdgeCount) {
                    isAt[here][curve] = true
                    continue
                }
                val there = mesh.regionOf(right.leftOf(edge) / 3)
                if (here == there) continue
                isAt[here][curve] = true
                isAt[there][curve] = true
            }
        }
    }

    /** Ascending. */
    fun of(region: Int): IntArray = isAt[region].indices.filter { isAt[region][it] }.toIntArray()
}
