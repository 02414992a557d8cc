package org.trigrid.io

import org.trigrid.domain.Region
import org.trigrid.mesh.MeshParts
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** What the writers need of a mesh, of three nodes an element and two an edge or of six and three; shares the mesh's arrays. */
internal class FileMesh private constructor(
    /** 1 or 2. */
    val order: Int,
    private val xy: DoubleArray,
    val elements: IntArray,
    val edges: IntArray,
    val edgeTags: IntArray,
    val boundaryEdgeCount: Int,
    val tags: List<String>,
    private val parts: MeshParts,
) {
    val nodesPerElement: Int get() = 3 * order
    val nodesPerEdge: Int get() = order + 1
    val nodeCount: Int get() = xy.size / 2
    val elementCount: Int get() = elements.size / nodesPerElement
    val taggedEdgeCount: Int get() = edgeTags.size

    val regions: List<Region> get() = parts.regions
    val pointCount: Int get() = parts.points.size

    /** Index into [regions]. */
    fun regionOf(element: Int): Int = parts.regionOf(element)

    fun pointNode(point: Int): Int = parts.points[point]

    fun pointTag(point: Int): Int = parts.pointTags[point]

    fun x(node: Int): Double = xy[2 * node]

    fun y(node: Int): Double = xy[2 * node + 1]

    /** Corners at [place] 0..2, middles of the edges at 3..5. */
    fun nodeOf(element: Int, place: Int): Int = elements[nodesPerElement * element + place]

    /** Start, end and middle at [place] 0..2. */
    fun nodeOn(edge: Int, place: Int): Int = edges[nodesPerEdge * edge + place]

    companion object {
        fun of(mesh: TriMesh): FileMesh = FileMesh(
            1, mesh.xy, mesh.elements, mesh.edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags, mesh.parts,
        )

        fun of(mesh: QuadraticMesh): FileMesh = FileMesh(
            2, mesh.xy, mesh.elements, mesh.edges, mesh.edgeTags, mesh.boundaryEdgeCount, mesh.tags, mesh.parts,
        )
    }
}
