package org.trigrid.io

/** Gmsh's numbers for types of elements, by the order of a mesh. */
internal object MshElements {
    private const val QUADRATIC_LINE = 8
    private const val QUADRATIC_TRIANGLE = 9

    fun line(mesh: FileMesh): Int = if (mesh.order == 2) QUADRATIC_LINE else MeshContents.LINE

    fun triangle(mesh: FileMesh): Int = if (mesh.order == 2) QUADRATIC_TRIANGLE else MeshContents.TRIANGLE
}
