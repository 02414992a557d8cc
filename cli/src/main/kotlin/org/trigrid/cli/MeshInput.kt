package org.trigrid.cli

import org.trigrid.io.MeshFormats
import org.trigrid.mesh.TriMesh
import java.nio.file.Path

/** Tells mesh files from domain files and reads them. */
internal object MeshInput {
    fun isMesh(file: Path): Boolean = MeshFormats.forReading(file) != null

    fun read(file: Path): TriMesh = InputFailure.naming(file) { MeshFormats.read(file) }
}
