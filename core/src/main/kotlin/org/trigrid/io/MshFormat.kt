package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/** Writes one version of Gmsh's mesh files. */
internal fun interface MshWriter {
    fun write(mesh: FileMesh, out: OutputStream)

    companion object {
        val VERSION_22 = MshWriter { mesh, out -> TextBuffer(out).let { Msh22Writer.write(mesh, it); it.flush() } }
        val VERSION_41 = MshWriter { mesh, out -> TextBuffer(out).let { Msh41Writer.write(mesh, it); it.flush() } }
        val BINARY_22 = MshWriter { mesh, out -> BinaryBuffer(out).let { Msh22BinaryWriter.write(mesh, it); it.flush() } }
        val BINARY_41 = MshWriter { mesh, out -> BinaryBuffer(out).let { Msh41BinaryWriter.write(mesh, it); it.flush() } }
    }
}

/** Gmsh's MSH. Which of its kinds a file is, its first line tells; all are read alike. */
internal class MshFormat(name: String, title: String, private val writer: MshWriter) :
    MeshFormat(name, title, listOf(".msh"), canRead = true, highestOrder = 2) {
    override fun write(mesh: FileMesh, out: OutputStream) = writer.write(mesh, out)

    override fun readEither(file: Path): ReadMesh {
        ReadingMemory.check(file, ReadingMemory.MSH)
        return MshReader.read(Files.readAllBytes(file), file.toString())
    }
}
