package org.trigrid.mesh

import org.trigrid.geometry.Predicates

/** The checks of nodes and elements each for itself. */
internal class ElementCheck(private val mesh: TriMesh, private val found: ViolationList) {
    fun checkCoordinates(): Boolean {
        var finite = true
        for (node in 0 until mesh.nodeCount) {
            if (!mesh.x(node).isFinite() || !mesh.y(node).isFinite()) {
                finite = false
                found.atNode(MeshViolationKind.NOT_A_NUMBER, node, "has a coordinate that is not a finite number")
            }
        }
        return finite
    }

    fun checkRanges(): Boolean {
        val nodes = mesh.nodeCount
        val elements = mesh.elementCount
        var sound = mesh.neighbours.size == mesh.elements.size && mesh.kinds.size == nodes
        for (half in mesh.elements.indices) {
            val inRange = mesh.elements[half] in 0 until nodes &&
                (!sound || mesh.neighbours[half] in TriMesh.NONE until elements)
            if (inRange) continue
            sound = false
            found.add(
                MeshViolationKind.WRONG_NEIGHBOUR, Double.NaN, Double.NaN,
                "element ${half / 3} refers to node ${mesh.elements[half]} or a neighbour that does not exist",
            )
        }
        for (node in mesh.edges) sound = sound && node in 0 until nodes
        return sound
    }

    fun checkPositive() {
        val xy = mesh.xy
        val e = mesh.elements
        for (t in 0 until mesh.elementCount) {
            val a = 2 * e[3 * t]
            val b = 2 * e[3 * t + 1]
            val c = 2 * e[3 * t + 2]
            val turn = Predicates.orient(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[c], xy[c + 1])
            if (turn > 0) continue
            found.atElement(MeshViolationKind.NOT_POSITIVE, t, if (turn < 0) "runs clockwise" else "is flat")
        }
    }

    fun checkUsed() {
        val used = BooleanArray(mesh.nodeCount)
        for (node in mesh.elements) used[node] = true
        for (node in used.indices) {
            if (!used[node]) found.atNode(MeshViolationKind.UNUSED_NODE, node, "belongs to no element")
        }
    }
}
