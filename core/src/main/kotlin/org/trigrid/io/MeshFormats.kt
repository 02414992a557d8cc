package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Path

/** Meshes to and from files. Bytes depend on the mesh alone: not on the platform, its language or its Java version. */
public object MeshFormats {
    private val ALL: List<MeshFormat> = java.util.List.of(
        MeshFormat.MSH_22, MeshFormat.MSH_41, MeshFormat.MSH_22_BINARY, MeshFormat.MSH_41_BINARY, MeshFormat.VTU,
        MeshFormat.TRIANGLE, MeshFormat.MEDIT, MeshFormat.ABAQUS, MeshFormat.SU2, MeshFormat.NASTRAN, MeshFormat.CSV,
        MeshFormat.JSON,
    )

    /** All formats; of those that share an ending, the usual one first. */
    @JvmStatic
    public fun all(): List<MeshFormat> = ALL

    /** The format of a short name, such as `msh41`, in any case; null if there is none. `2.2` and `4.1` are the ASCII ones of Gmsh. */
    @JvmStatic
    public fun named(name: String): MeshFormat? = when (name) {
        "2.2" -> MeshFormat.MSH_22
        "4.1" -> MeshFormat.MSH_41
        else -> ALL.firstOrNull { it.name.equals(name, ignoreCase = true) }
    }

    /** The format in which a mesh is written to a file of this name, by its ending; null if the ending says nothing. */
    @JvmStatic
    public fun forWriting(file: Path): MeshFormat? = ALL.firstOrNull { it.canWrite && it.fits(file) }

    /** The format in which a mesh is read from a file of this name, by its ending; null if it is no mesh file that can be read. */
    @JvmStatic
    public fun forReading(file: Path): MeshFormat? = ALL.firstOrNull { it.canRead && it.fits(file) && !isDomainOfTriangle(it, file) }

    /** Triangle's `.poly` holds what is to be meshed; its meshes are read by their `.ele` or `.node`. */
    private fun isDomainOfTriangle(format: MeshFormat, file: Path) = format === MeshFormat.TRIANGLE && format.endingOf(file) == ".poly"

    /**
     * Writes [mesh] to [path] in the format of its ending, MSH 2.2 if that says nothing; a file is written beside its
     * place and moved over it.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, path: Path): Unit = write(mesh, path, forWriting(path) ?: MeshFormat.MSH_22)

    /**
     * Writes [mesh] to [path]; a file is written beside its place and moved over it. A format of several files puts them
     * all beside [path], each with its own ending.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, path: Path, format: MeshFormat): Unit = format.writeFiles(mesh, path)

    /**
     * Writes [mesh] to a stream, which stays open.
     *
     * @throws IllegalArgumentException if the format is several files.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: TriMesh, out: OutputStream, format: MeshFormat): Unit = format.write(mesh, out)

    /**
     * Writes a mesh of six-node triangles to [path] in the format of its ending, MSH 2.2 if that says nothing.
     *
     * @throws IllegalArgumentException if the format has no such elements, see [MeshFormat.highestOrder].
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: QuadraticMesh, path: Path): Unit = write(mesh, path, forWriting(path) ?: MeshFormat.MSH_22)

    /** As the other, in a given format. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: QuadraticMesh, path: Path, format: MeshFormat) {
        format.requireSecondOrder()
        AtomicFile.write(path) { format.write(FileMesh.of(mesh), it) }
    }

    /** As the other, to a stream, which stays open. */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(mesh: QuadraticMesh, out: OutputStream, format: MeshFormat) {
        format.requireSecondOrder()
        format.write(FileMesh.of(mesh), out)
    }

    /**
     * Reads a mesh of triangles: Gmsh's MSH 2.2 and 4.1, ASCII or binary; VTU; Medit; Triangle's, by its `.ele` or
     * `.node`. The ending tells which, MSH if it says nothing. Nodes keep the order of the file; nodes of no triangle are
     * left out, clockwise triangles are turned. Lines give their groups to the edges.
     *
     * @throws FileFormatException if the file is no such mesh; it says where. Also if its triangles have six nodes.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun read(path: Path): TriMesh {
        val mesh = readEither(path)
        if (mesh.order != 1) throw FileFormatException(path.toString(), 0, 0, "the elements have six nodes, not three")
        return mesh.corners
    }

    /**
     * As [read], also of triangles of six nodes, except from Triangle's files. They are taken as they are: edges inside may be
     * curved too, and [QuadraticMesh.leastJacobian] tells whether an element is folded.
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun readEither(path: Path): ReadMesh = (forReading(path) ?: MeshFormat.MSH_22).readEither(path)
}
