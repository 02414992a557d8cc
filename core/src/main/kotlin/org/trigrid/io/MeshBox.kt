package org.trigrid.io

import org.trigrid.mesh.TriMesh

/** The box round some nodes of a mesh; all 0 round none. */
internal class MeshBox private constructor() {
    private var count = 0
    var minX = 0.0
        private set
    var minY = 0.0
        private set
    var maxX = 0.0
        private set
    var maxY = 0.0
        private set

    private fun add(mesh: TriMesh, node: Int) {
        val x = mesh.x(node)
        val y = mesh.y(node)
        val isFirst = count++ == 0
        minX = if (isFirst) x else minOf(minX, x)
        minY = if (isFirst) y else minOf(minY, y)
        maxX = if (isFirst) x else maxOf(maxX, x)
        maxY = if (isFirst) y else maxOf(maxY, y)
    }

    companion object {
        fun of(mesh: TriMesh): MeshBox = MeshBox().apply { for (node in 0 until mesh.nodeCount) add(mesh, node) }

        fun ofCurve(mesh: TriMesh, groups: MeshGroups, curve: Int): MeshBox = MeshBox().apply {
            for (k in 0 until groups.size(curve)) {
                add(mesh, mesh.edgeStart(groups.edge(curve, k)))
                add(mesh, mesh.edgeEnd(groups.edge(curve, k)))
            }
        }
    }
}
