package org.trigrid.spark

import org.apache.spark.sql.types.StructField
import org.trigrid.domain.Region
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
        val quadratic = mesh.quadratic
        if (quadratic == null) putArrays(row, mesh.linear) else putArrays(row, quadratic)
    }

    private fun putArrays(row: MeshRow, mesh: TriMesh) {
        row.set(MeshColumns.COORDINATES, mesh.nodeCoordinates())
        row.set(MeshColumns.ELEMENT_NODES, mesh.elementNodes())
        row.set(MeshColumns.EDGE_NODES, IntArray(2 * mesh.taggedEdgeCount) { if (it % 2 == 0) mesh.edgeStart(it / 2) else mesh.edgeEnd(it / 2) })
        row.set(MeshColumns.EDGE_TAGS, IntArray(mesh.taggedEdgeCount) { mesh.edgeTag(it) })
        row.set(MeshColumns.BOUNDARY_EDGES, mesh.boundaryEdgeCount)
        row.set(MeshColumns.TAGS, mesh.tags.toTypedArray())
        putRegions(row, mesh.regions, IntArray(mesh.elementCount) { mesh.regionOf(it) })
        row.set(MeshColumns.POINT_NODES, IntArray(mesh.pointCount) { mesh.pointNode(it) })
        row.set(MeshColumns.POINT_TAGS, IntArray(mesh.pointCount) { mesh.pointTag(it) })
    }

    private fun putArrays(row: MeshRow, mesh: QuadraticMesh) {
        row.set(MeshColumns.COORDINATES, mesh.nodeCoordinates())
        row.set(MeshColumns.ELEMENT_NODES, mesh.elementNodes())
        row.set(MeshColumns.EDGE_NODES, IntArray(3 * mesh.taggedEdgeCount) { edgeNode(mesh, it / 3, it % 3) })
        row.set(MeshColumns.EDGE_TAGS, IntArray(mesh.taggedEdgeCount) { mesh.edgeTag(it) })
        row.set(MeshColumns.BOUNDARY_EDGES, mesh.boundaryEdgeCount)
        row.set(MeshColumns.TAGS, mesh.tags.toTypedArray())
        putRegions(row, mesh.regions, IntArray(mesh.elementCount) { mesh.regionOf(it) })
        row.set(MeshColumns.POINT_NODES, IntArray(mesh.pointCount) { mesh.pointNode(it) })
        row.set(MeshColumns.POINT_TAGS, IntArray(mesh.pointCount) { mesh.pointTag(it) })
    }

    private fun putRegions(row: MeshRow, regions: List<Region>, elementRegions: IntArray) {
        row.set(MeshColumns.ELEMENT_REGIONS, elementRegions)
        row.set(MeshColumns.REGIONS, Array(regions.size) { regions[it].name })
        row.set(MeshColumns.MATERIALS, IntArray(regions.size) { regions[it].material })
    }

    /** Start, end and middle at [place] 0..2. */
    private fun edgeNode(mesh: QuadraticMesh, edge: Int, place: Int): Int = when (place) {
        0 -> mesh.edgeStart(edge)
        1 -> mesh.edgeEnd(edge)
        else -> mesh.edgeMiddle(edge)
    }

    companion object {
        private const val serialVersionUID = 1L

        fun columns(hasArrays: Boolean, hasFile: Boolean): List<StructField> =
            (if (hasArrays) MeshColumns.ARRAYS else emptyList()) + (if (hasFile) listOf(MeshColumns.FILE_BYTES) else emptyList())
    }
}
