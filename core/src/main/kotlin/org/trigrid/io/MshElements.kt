package org.trigrid.io

/** Gmsh's numbers for types of elements, by the order of a mesh. */
internal object MshElements {
    fun line(mesh: FileMesh): Int = if (mesh.order == 2) MeshContents.QUADRATIC_LINE else MeshContents.LINE

    fun triangle(mesh: FileMesh): Int = if (mesh.order == 2) MeshContents.QUADRATIC_TRIANGLE else MeshContents.TRIANGLE
}
