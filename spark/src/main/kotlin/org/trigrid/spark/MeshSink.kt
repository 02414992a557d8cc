package org.trigrid.spark

import org.apache.spark.sql.types.StructField
import org.trigrid.io.MeshFormat
import org.trigrid.io.MeshFormats
import org.trigrid.mesh.QuadraticMesh
import org.trigrid.mesh.TriMesh
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.Serializable

/** A mesh of three-node elements, and that of six-node ones made of it where those are wanted. */
internal class MadeMesh(val linear: TriMesh, val quadratic: QuadraticMesh?) {
    @Throws(IOException::class)
    fun write(out: OutputStream, format: MeshFormat) {
        if (quadratic == null) MeshFormats.write(linear, out, format) else MeshFormats.write(quadratic, out, format)
    }
}

/** Where meshes go. What it throws ends the task, which Spark tries again. */
internal interface MeshSink : Serializable {
    /** The columns that it fills. */
    val columns: List<StructField>

    /** @param domain which of the [domainCount] of its outline. */
    @Throws(IOException::class)
    fun put(row: MeshRow, outline: Outline, domain: Int, domainCount: Int, mesh: MadeMesh)
}

/** Meshes as columns: their arrays, the bytes of their files, or both. */
internal class ColumnsSink(private val hasArrays: Boolean, private val formatName: String?) : MeshSink {
    override val columns: List<StructField> get() = columns(hasArrays, formatName != null)

    override fun put(row: MeshRow, outline: Outline, domain: Int, domainCount: Int, mesh: MadeMesh) {
        if (hasArrays) putArrays(row, mesh)
        val format = formatName?.let { MeshFormats.named(it) } ?: return
        val bytes = ByteArrayOutputStream()
        mesh.write(bytes, format)
        row.set(MeshColumns.FILE, bytes.toByteArray())
    }

    private fun putArrays(row: MeshRow, mesh: MadeMesh) {
        val linear = mesh.linear
        val quadratic = mesh.quadratic
        row.set(MeshColumns.COORDINATES, quadratic?.nodeCoordinates() ?: linear.nodeCoordinates())
        row.set(MeshColumns.ELEMENT_NODES, quadratic?.elementNodes() ?: linear.elementNodes())
        row.set(MeshColumns.EDGE_NODES, quadratic?.let { edgeNodes(it) } ?: edgeNodes(linear))
        row.set(MeshColumns.EDGE_TAGS, IntArray(linear.taggedEdgeCount) { linear.edgeTag(it) })
        row.set(MeshColumns.BOUNDARY_EDGES, linear.boundaryEdgeCount)
        row.set(MeshColumns.TAGS, linear.tags.toTypedArray())
    }

    private fun edgeNodes(mesh: TriMesh) =
        IntArray(2 * mesh.taggedEdgeCount) { if (it % 2 == 0) mesh.edgeStart(it / 2) else mesh.edgeEnd(it / 2) }

    private fun edgeNodes(mesh: QuadraticMesh) = IntArray(3 * mesh.taggedEdgeCount) {
        when (it % 3) {
            0 -> mesh.edgeStart(it / 3)
            1 -> mesh.edgeEnd(it / 3)
            else -> mesh.edgeMiddle(it / 3)
        }
    }

    companion object {
        private const val serialVersionUID = 1L

        fun columns(hasArrays: Boolean, hasFile: Boolean): List<StructField> =
            (if (hasArrays) MeshColumns.ARRAYS else emptyList()) + (if (hasFile) listOf(MeshColumns.FILE_BYTES) else emptyList())
    }
}
