package org.trigrid.cli

import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.EdgeMiddles
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import org.trigrid.numbering.Numbering
import org.trigrid.numbering.NumberingMethod
import java.nio.file.Path

/** A mesh to be written, with elements of three nodes or of six. */
internal class OrderedMesh private constructor(private val linear: TriMesh, val quadratic: QuadraticMesh?) {
    fun write(file: Path, format: MeshFormat) {
        if (quadratic == null) MeshFormats.write(linear, file, format) else MeshFormats.write(quadratic, file, format)
    }

    companion object {
        /** @param middles asked for only if [order] is 2. */
        fun of(mesh: TriMesh, order: Int, numbering: NumberingMethod, middles: () -> EdgeMiddles): OrderedMesh {
            if (order == 1) return OrderedMesh(mesh, null)
            return OrderedMesh(mesh, Numbering.renumber(QuadraticMesh.of(mesh, middles()), numbering))
        }
    }
}
