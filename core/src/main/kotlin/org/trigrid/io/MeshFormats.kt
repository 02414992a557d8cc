package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.TriMesh
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/** Meshes to and from files. Bytes depend on the mesh alone: not on the platform, its language or its Java version. */
public object MeshFormats {
    /** Writes [mesh] to [path] as MSH 2.2; the file is written beside its place and moved over it. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, path: Path): Unit = write(mesh, path, MeshFormat.MSH_22)

    /** Writes [mesh] to [path]; the file is written beside its place and moved over it. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, path: Path, format: MeshFormat): Unit =
        AtomicFile.write(path) { write(mesh, it, format) }

    /** Writes [mesh] to a stream, which stays open. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, out: OutputStream, format: MeshFormat) {
        val text = TextBuffer(out)
        when (format) {
            MeshFormat.MSH_22 -> Msh22Writer.write(mesh, text)
            MeshFormat.MSH_41 -> Msh41Writer.write(mesh, text)
        }
        text.flush()
    }

    /**
     * Reads a mesh of triangles from a Gmsh file, MSH 2.2 or 4.1, ASCII. Nodes keep the order of the file; nodes of no
     * triangle are left out, clockwise triangles are turned. Lines give their physical groups to the edges.
     *
     * @throws FileFormatException if the file is no such mesh; it says where.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(path: Path): TriMesh {
        ReadingMemory.check(path, ReadingMemory.MSH)
        return MshReader.read(Files.readAllBytes(path), path.toString())
    }
}
