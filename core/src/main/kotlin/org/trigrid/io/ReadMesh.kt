package org.trigrid.io

import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh

/** A mesh as a file has it, its elements of three nodes or of six. */
public class ReadMesh internal constructor(
    /** The mesh of the elements' corners, all of it where elements have three nodes. */
    @get:JvmName("corners") public val corners: TriMesh,
    /** The mesh of six-node elements, its nodes in the order of the file; null where elements have three. */
    @get:JvmName("quadratic") public val quadratic: QuadraticMesh?,
) {
    /** 1 for elements of three nodes, 2 for those of six. */
    @get:JvmName("order")
    public val order: Int get() = if (quadratic == null) 1 else 2

    override fun toString(): String = "order $order, ${quadratic?.nodeCount ?: corners.nodeCount} nodes, ${corners.elementCount} elements"
}
