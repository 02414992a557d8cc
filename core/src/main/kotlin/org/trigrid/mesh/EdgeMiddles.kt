package org.trigrid.mesh

/** Where the middles of tagged edges lie, for boundaries that are not straight. */
public fun interface EdgeMiddles {
    /**
     * @param mesh the mesh whose edges are halved.
     * @param edge number of a tagged edge.
     * @return x and y of its middle.
     */
    public fun middleOf(mesh: TriMesh, edge: Int): DoubleArray

    public companion object {
        /** Halfway between the ends. */
        @JvmField
        public val STRAIGHT: EdgeMiddles = EdgeMiddles { mesh, edge ->
            val a = mesh.edgeStart(edge)
            val b = mesh.edgeEnd(edge)
            doubleArrayOf(mesh.x(a) + 0.5 * (mesh.x(b) - mesh.x(a)), mesh.y(a) + 0.5 * (mesh.y(b) - mesh.y(a)))
        }
    }
}
