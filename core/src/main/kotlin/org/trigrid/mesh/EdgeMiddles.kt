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
            doubleArrayOf(halfway(mesh.x(a), mesh.x(b)), halfway(mesh.y(a), mesh.y(b)))
        }

        /** The same double from both ends. */
        internal fun halfway(a: Double, b: Double): Double = 0.5 * a + 0.5 * b
    }
}
