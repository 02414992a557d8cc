package org.trigrid.cli

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.io.DomainFormats
import org.trigrid.io.MeshFormats
import org.trigrid.io.ReadMesh
import org.trigrid.mesh.TriMesh
import org.trigrid.project.DomainInputs
import java.nio.file.Files
import java.nio.file.Path

/** Tells mesh files from domain files and reads them. */
internal object MeshInput {
    fun isMesh(file: Path): Boolean = MeshFormats.forReading(file) != null

    /** Of elements of three nodes. */
    fun read(file: Path): TriMesh {
        val mesh = readEither(file)
        if (mesh.order == 1) return mesh.corners
        val advice = "'trigrid convert --order 1' leaves their corners"
        throw InputFailure(file.toString(), FileFormatException(file.toString(), 0, 0, "the elements have six nodes, not three; $advice"))
    }

    /** Also of elements of six nodes. */
    fun readEither(file: Path): ReadMesh = InputFailure.naming(file) {
        val holdsDomains = !isMesh(file) && (DomainInputs.isProject(file) || DomainFormats.forFile(file) != null)
        if (holdsDomains && Files.exists(file)) {
            throw FileFormatException(file.toString(), 0, 0, "this is a file of domains, not of a mesh; 'trigrid mesh' makes one")
        }
        MeshFormats.readEither(file)
    }
}
