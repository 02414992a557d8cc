package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Path

/** A format of mesh files. */
public abstract class MeshFormat internal constructor(
    name: String,
    title: String,
    endings: List<String>,
    canRead: Boolean,
    canWrite: Boolean = true,
    /** Whether a mesh is one file; else several that differ by their endings. */
    @get:JvmName("isSingleFile") public val isSingleFile: Boolean = true,
    /** 1 for elements of three nodes only; 2 if those of six can be written too. */
    @get:JvmName("highestOrder") public val highestOrder: Int = 1,
) : FileFormat(name, title, endings, canRead, canWrite) {
    /** The files that a mesh written to [file] is in. */
    public open fun filesOf(file: Path): List<Path> = listOf(file)

    /** Writes the one file of a mesh. */
    @Throws(IOException::class)
    internal open fun write(mesh: TriMesh, out: OutputStream): Unit = write(FileMesh.of(mesh), out)

    /** Writes the one file of a mesh of either order; formats of order 1 may do without. */
    @Throws(IOException::class)
    internal open fun write(mesh: FileMesh, out: OutputStream): Unit = throw IllegalArgumentException("$name is several files")

    /** @throws IllegalArgumentException unless the format has elements of six nodes. */
    internal fun requireSecondOrder() {
        val able = MeshFormats.all().filter { it.highestOrder >= 2 }.joinToString { it.name }
        require(highestOrder >= 2) { "$name has no elements of six nodes; these have: $able" }
    }

    /** Writes all files of a mesh. */
    @Throws(IOException::class)
    internal open fun writeFiles(mesh: TriMesh, file: Path): Unit = AtomicFile.write(file) { write(mesh, it) }

    /** @throws org.trigrid.diagnostics.FileFormatException with the place of what is wrong. */
    @Throws(IOException::class)
    internal open fun readEither(file: Path): ReadMesh = throw IllegalArgumentException("$name cannot be read")

    public companion object {
        /** Gmsh MSH 2.2, ASCII; read by nearly every solver. */
        @JvmField
        public val MSH_22: MeshFormat = MshFormat("msh22", "Gmsh MSH 2.2, ASCII", MshWriter.VERSION_22)

        /** Gmsh MSH 4.1, ASCII. */
        @JvmField
        public val MSH_41: MeshFormat = MshFormat("msh41", "Gmsh MSH 4.1, ASCII", MshWriter.VERSION_41)

        /** Gmsh MSH 2.2, binary, little-endian. */
        @JvmField
        public val MSH_22_BINARY: MeshFormat = MshFormat("msh22-binary", "Gmsh MSH 2.2, binary", MshWriter.BINARY_22)

        /** Gmsh MSH 4.1, binary, little-endian. */
        @JvmField
        public val MSH_41_BINARY: MeshFormat = MshFormat("msh41-binary", "Gmsh MSH 4.1, binary", MshWriter.BINARY_41)

        /** VTK's XML unstructured grid, for ParaView. */
        @JvmField
        public val VTU: MeshFormat = VtuFormat()

        /** Triangle's files `.node`, `.ele`, `.edge` and `.poly`. */
        @JvmField
        public val TRIANGLE: MeshFormat = TriangleFormat()

        /** Medit's `.mesh`, ASCII; also read by mmg and FreeFem. */
        @JvmField
        public val MEDIT: MeshFormat = MeditFormat()

        /** Input files of Abaqus and CalculiX. */
        @JvmField
        public val ABAQUS: MeshFormat = AbaqusFormat()

        /** SU2's native format. */
        @JvmField
        public val SU2: MeshFormat = Su2Format()

        /** Nastran bulk data with large fields for coordinates. */
        @JvmField
        public val NASTRAN: MeshFormat = NastranFormat()

        /** Three tables: `.nodes.csv`, `.elements.csv`, `.edges.csv`. */
        @JvmField
        public val CSV: MeshFormat = MeshCsvFormat()

        /** Arrays of nodes, elements and edges in JSON. */
        @JvmField
        public val JSON: MeshFormat = MeshJsonFormat()
    }
}
