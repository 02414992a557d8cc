package org.trigrid.cli

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import java.nio.file.Path

/** Tells mesh files from domain files and reads them. */
internal object MeshInput {
    fun isMesh(file: Path): Boolean = MeshFormats.forReading(file) != null

    fun read(file: Path): TriMesh = InputFailure.naming(file) { MeshFormats.read(file) }

    /** Calls [linear] or, for a mesh of six-node triangles, [quadratic] with the mesh of [file]. */
    inline fun <T> readEither(file: Path, linear: (TriMesh) -> T, quadratic: (QuadraticMesh) -> T): T {
        val mesh = InputFailure.naming(file) {
            try {
                MeshFormats.read(file)
            } catch (error: FileFormatException) {
                if (!isQuadratic(file)) throw error else null
            }
        }
        if (mesh != null) return linear(mesh)
        return quadratic(InputFailure.naming(file) { MeshFormats.readSecondOrder(file) })
    }

    /** Only asked of files that are no mesh of three-node triangles, so that others are read once. */
    fun isQuadratic(file: Path): Boolean = try {
        MeshFormats.orderOf(file) == 2
    } catch (_: FileFormatException) {
        false
    }
}
