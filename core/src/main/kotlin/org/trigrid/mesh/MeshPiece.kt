package org.trigrid.mesh

/** Some of a mesh's elements as a mesh of their own, in which the nodes shared with other parts are fixed. */
internal class MeshPiece(
    val mesh: MutableMesh,
    /** Per node of [mesh], as it was cut out, its number in the whole; ascending for the fixed ones. */
    val wholeNodes: IntArray,
)
