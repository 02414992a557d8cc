package org.trigrid.spacing

import org.trigrid.domain.Domain
import org.trigrid.mesh.TriMesh

/**
 * How far the inner edges of a mesh are from the sizes that the spacing of the boundary alone asks for.
 *
 * The size at a place is linear in the triangles of the domain's constrained Delaunay triangulation, between the mean
 * lengths of the segments that end in their nodes; no gradation limits it.
 */
public object SizeDeviation {
    /**
     * Mean over the inner edges of |log2(length / size at the edge's middle)|, dimensionless: 0 where each edge is as
     * long as asked for, 1 where it is twice or half as long on average. NaN for a mesh without inner edges.
     *
     * @param domain the valid domain of which [mesh] is the mesh, whichever mesher made it.
     * @throws org.trigrid.diagnostics.InvalidDomainException if a fault of the domain prevents its triangulation.
     */
    @JvmStatic
    public fun of(mesh: TriMesh, domain: Domain): Double {
        val sizes = SizeFields.nodeSizes(domain)
        val triangulation = ConstrainedDelaunay.of(domain)
        val walk = TriangleWalk(triangulation)
        var near = 0
        var sum = 0.0
        var count = 0
        for (element in 0 until mesh.elementCount) {
            for (k in 0..2) {
                if (mesh.neighbourOf(element, k) < element) continue
                val a = mesh.nodeOf(element, k)
                val b = mesh.nodeOf(element, (k + 1) % 3)
                val length = Math.hypot(mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a))
                near = walk.find(0.5 * (mesh.x(a) + mesh.x(b)), 0.5 * (mesh.y(a) + mesh.y(b)), near)
                sum += Math.abs(StrictMath.log(length / interpolated(triangulation, near, walk, sizes)))
                count++
            }
        }
        return sum / count / StrictMath.log(2.0)
    }

    private fun interpolated(triangulation: ConstrainedDelaunay, triangle: Int, walk: TriangleWalk, sizes: DoubleArray): Double {
        val u = Math.max(0.0, walk.weight0)
        val v = Math.max(0.0, walk.weight1)
        val w = Math.max(0.0, walk.weight2)
        val nodes = triangulation.nodes
        val at = 3 * triangle
        return (u * sizes[nodes[at]] + v * sizes[nodes[at + 1]] + w * sizes[nodes[at + 2]]) / (u + v + w)
    }
}
