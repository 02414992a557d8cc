package org.trigrid.quality

import org.trigrid.mesh.TriMesh

/** Measures of one triangle from raw coordinates. */
internal object TriangleQuality {
    private const val TWO_ROOT_3 = 3.4641016151377544

    /**
     * Shape quality q = 4 sqrt(3) A / (l1^2 + l2^2 + l3^2): 1 for an equilateral triangle, 0 for a flat one, negative
     * for a clockwise one (Bank and Smith 1997, SIAM J. Numer. Anal. 34:979-997; Field 2000, IJNME 47:887-906).
     */
    @JvmStatic
    fun shape(ax: Double, ay: Double, bx: Double, by: Double, cx: Double, cy: Double): Double {
        val ux = bx - ax
        val uy = by - ay
        val vx = cx - ax
        val vy = cy - ay
        val wx = cx - bx
        val wy = cy - by
        return TWO_ROOT_3 * (ux * vy - uy * vx) / (ux * ux + uy * uy + vx * vx + vy * vy + wx * wx + wy * wy)
    }

    /** [shape] of an element of a mesh. */
    fun of(mesh: TriMesh, element: Int): Double {
        val a = mesh.nodeOf(element, 0)
        val b = mesh.nodeOf(element, 1)
        val c = mesh.nodeOf(element, 2)
        return shape(mesh.x(a), mesh.y(a), mesh.x(b), mesh.y(b), mesh.x(c), mesh.y(c))
    }
}
