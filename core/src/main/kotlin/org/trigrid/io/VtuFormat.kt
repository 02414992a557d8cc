package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * VTK's XML unstructured grid, numbers appended as raw binary: triangles, then the tagged edges as lines, then points as vertices. The cell arrays
 * `region` and `tag` number the groups from 1, 0 for none; the field arrays `region_names` and `tag_names` hold their names,
 * one a line.
 */
internal class VtuFormat : MeshFormat("vtu", "VTK XML unstructured grid", listOf(".vtu"), canRead = true, highestOrder = 2) {
    override fun write(mesh: FileMesh, out: OutputStream) {
        val groups = MeshGroups(mesh)
        val curveNames = (groups.curveNames + groups.pointNames).joinToString("\n").toByteArray(Charsets.US_ASCII)
        val regionNames = groups.regionNames.joinToString("\n").toByteArray(Charsets.US_ASCII)
        val binary = BinaryBuffer(out)
        writeHeader(mesh, curveNames.size, regionNames.size, binary)
        writeBytes(regionNames, binary)
        writeBytes(curveNames, binary)
        writePoints(mesh, binary)
        writeCells(mesh, groups, binary)
        writeGroups(mesh, groups, binary)
        binary.line("").line("  </AppendedData>").line("</VTKFile>")
        binary.flush()
    }

    private fun writeHeader(mesh: FileMesh, curveNames: Int, regionNames: Int, out: BinaryBuffer) {
        val cells = cells(mesh)
        val nodes = nodes(mesh)
        var offset = 0L
        fun array(type: String, name: String, bytes: Long, more: String = "") {
            out.line("        <DataArray type=\"$type\" Name=\"$name\"$more format=\"appended\" offset=\"$offset\"/>")
            offset += Long.SIZE_BYTES + bytes
        }
        out.line("<?xml version=\"1.0\"?>")
        out.line("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">")
        out.line("  <UnstructuredGrid>").line("    <FieldData>")
        array("UInt8", "region_names", regionNames.toLong(), " NumberOfTuples=\"$regionNames\"")
        array("UInt8", "tag_names", curveNames.toLong(), " NumberOfTuples=\"$curveNames\"")
        out.line("    </FieldData>").line("    <Piece NumberOfPoints=\"${mesh.nodeCount}\" NumberOfCells=\"$cells\">")
        out.line("      <Points>")
        array("Float64", "Points", 24L * mesh.nodeCount, " NumberOfComponents=\"3\"")
        out.line("      </Points>").line("      <Cells>")
        array("Int32", "connectivity", 4 * nodes)
        array("Int32", "offsets", 4L * cells)
        array("UInt8", "types", cells.toLong())
        out.line("      </Cells>").line("      <CellData>")
        array("Int32", "region", 4L * cells)
        array("Int32", "tag", 4L * cells)
        out.line("      </CellData>").line("    </Piece>").line("  </UnstructuredGrid>")
        out.line("  <AppendedData encoding=\"raw\">").text("_")
    }

    private fun writeBytes(bytes: ByteArray, out: BinaryBuffer) {
        out.long(bytes.size)
        for (b in bytes) out.byte(b.toInt())
    }

    private fun writePoints(mesh: FileMesh, out: BinaryBuffer) {
        out.long(24L * mesh.nodeCount)
        for (node in 0 until mesh.nodeCount) out.double(mesh.x(node)).double(mesh.y(node)).double(0.0)
    }

    private fun writeCells(mesh: FileMesh, groups: MeshGroups, out: BinaryBuffer) {
        val cells = cells(mesh)
        out.long(4L * nodes(mesh))
        for (node in mesh.elements) out.int(node)
        for (curve in 0 until groups.curveCount) {
            for (k in 0 until groups.size(curve)) {
                val edge = groups.edge(curve, k)
                for (place in 0 until mesh.nodesPerEdge) out.int(mesh.nodeOn(edge, place))
            }
        }
        for (p in 0 until mesh.pointCount) out.int(mesh.pointNode(p))
        out.long(4L * cells)
        for (element in 1..mesh.elementCount) out.int(mesh.nodesPerElement * element)
        for (edge in 1..mesh.taggedEdgeCount) out.int(mesh.elements.size + mesh.nodesPerEdge * edge)
        for (p in 1..mesh.pointCount) out.int(mesh.elements.size + mesh.edges.size + p)
        out.long(cells)
        repeat(mesh.elementCount) { out.byte(if (mesh.order == 2) VTK_QUADRATIC_TRIANGLE else VTK_TRIANGLE) }
        repeat(mesh.taggedEdgeCount) { out.byte(if (mesh.order == 2) VTK_QUADRATIC_EDGE else VTK_LINE) }
        repeat(mesh.pointCount) { out.byte(VTK_VERTEX) }
    }

    private fun writeGroups(mesh: FileMesh, groups: MeshGroups, out: BinaryBuffer) {
        val bytes = 4L * cells(mesh)
        out.long(bytes)
        for (element in 0 until mesh.elementCount) out.int(mesh.regionOf(element) + 1)
        repeat(mesh.taggedEdgeCount + mesh.pointCount) { out.int(0) }
        out.long(bytes)
        repeat(mesh.elementCount) { out.int(0) }
        for (curve in 0 until groups.curveCount) repeat(groups.size(curve)) { out.int(curve + 1) }
        for (p in 0 until mesh.pointCount) out.int(groups.curveCount + groups.groupOfPoint(p) + 1)
    }

    private fun cells(mesh: FileMesh): Int = mesh.elementCount + mesh.taggedEdgeCount + mesh.pointCount

    private fun nodes(mesh: FileMesh): Long = mesh.elements.size.toLong() + mesh.edges.size + mesh.pointCount

    override fun readEither(file: Path): ReadMesh {
        ReadingMemory.check(file, ReadingMemory.VTU)
        return VtuReader.read(Files.readAllBytes(file), file.toString())
    }

    companion object {
        const val VTK_VERTEX = 1
        const val VTK_LINE = 3
        const val VTK_TRIANGLE = 5
        const val VTK_QUADRATIC_EDGE = 21
        const val VTK_QUADRATIC_TRIANGLE = 22
    }
}
