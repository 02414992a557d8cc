package org.trigrid.io

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

    private fun add(mesh: FileMesh, node: Int) {
        val x = mesh.x(node)
        val y = mesh.y(node)
        val isFirst = count++ == 0
        minX = if (isFirst) x else minOf(minX, x)
        minY = if (isFirst) y else minOf(minY, y)
        maxX = if (isFirst) x else maxOf(maxX, x)
        maxY = if (isFirst) y else maxOf(maxY, y)
    }

    companion object {
        fun of(mesh: FileMesh): MeshBox = MeshBox().apply { for (node in 0 until mesh.nodeCount) add(mesh, node) }

        fun ofRegion(mesh: FileMesh, region: Int): MeshBox = MeshBox().apply {
            for (at in mesh.elements.indices) {
                if (mesh.regionOf(at / mesh.nodesPerElement) == region) add(mesh, mesh.elements[at])
            }
        }

        fun ofCurve(mesh: FileMesh, groups: MeshGroups, curve: Int): MeshBox = MeshBox().apply {
            for (k in 0 until groups.size(curve)) {
                for (place in 0 until mesh.nodesPerEdge) add(mesh, mesh.nodeOn(groups.edge(curve, k), place))
            }
        }
    }
}
