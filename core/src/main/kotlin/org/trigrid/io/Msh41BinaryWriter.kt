package org.trigrid.io

/** Gmsh's MSH 4.1, binary: as [Msh41Writer], with counts, node numbers and element numbers of 8 bytes. */
internal object Msh41BinaryWriter {
    fun write(mesh: FileMesh, out: BinaryBuffer) {
        val groups = MeshGroups(mesh)
        out.line("\$MeshFormat").line("4.1 1 8").int(1).line("").line("\$EndMeshFormat")
        Msh22BinaryWriter.writeNames(groups, out)
        writeEntities(mesh, groups, out)
        writeNodes(mesh, out)
        writeElements(mesh, groups, out)
    }

    private fun writeEntities(mesh: FileMesh, groups: MeshGroups, out: BinaryBuffer) {
        out.line("\$Entities").long(mesh.pointCount).long(groups.curveCount).long(groups.regionCount).long(0)
        for (p in 0 until mesh.pointCount) {
            out.int(p + 1).double(mesh.x(mesh.pointNode(p))).double(mesh.y(mesh.pointNode(p))).double(0.0)
            out.long(1).int(groups.pointId(groups.groupOfPoint(p)))
        }
        for (i in 0 until groups.curveCount) {
            out.int(i + 1)
            writeBox(MeshBox.ofCurve(mesh, groups, i), out)
            out.long(1).int(groups.curveId(i)).long(0)
        }
        val bounding = BoundingCurves(mesh, groups)
        for (region in 0 until groups.regionCount) {
            out.int(region + 1)
            writeBox(MeshBox.ofRegion(mesh, region), out)
            val curves = bounding.of(region)
            out.long(1).int(groups.regionId(region)).long(curves.size)
            for (i in curves) out.int(i + 1)
        }
        out.line("").line("\$EndEntities")
    }

    private fun writeBox(box: MeshBox, out: BinaryBuffer) {
        out.double(box.minX).double(box.minY).double(0.0).double(box.maxX).double(box.maxY).double(0.0)
    }

    private fun writeNodes(mesh: FileMesh, out: BinaryBuffer) {
        val count = mesh.nodeCount
        out.line("\$Nodes").long(1).long(count).long(minOf(1, count)).long(count)
        out.int(2).int(1).int(0).long(count)
        for (node in 1..count) out.long(node)
        for (node in 0 until count) out.double(mesh.x(node)).double(mesh.y(node)).double(0.0)
        out.line("").line("\$EndNodes")
    }

    private fun writeElements(mesh: FileMesh, groups: MeshGroups, out: BinaryBuffer) {
        val count = mesh.pointCount + mesh.taggedEdgeCount + mesh.elementCount
        val blocks = mesh.pointCount + groups.curveCount + groups.regionCount
        out.line("\$Elements").long(blocks).long(count).long(minOf(1, count)).long(count)
        var id = 1
        for (p in 0 until mesh.pointCount) {
            out.int(0).int(p + 1).int(MeshContents.POINT).long(1).long(id++).long(mesh.pointNode(p) + 1)
        }
        for (i in 0 until groups.curveCount) {
            out.int(1).int(i + 1).int(MshElements.line(mesh)).long(groups.size(i))
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                out.long(id++)
                for (place in 0 until mesh.nodesPerEdge) out.long(mesh.nodeOn(edge, place) + 1)
            }
        }
        for (region in 0 until groups.regionCount) {
            val elements = groups.elements(region)
            out.int(2).int(region + 1).int(MshElements.triangle(mesh)).long(elements.size)
            for (element in elements) {
                out.long(id++)
                for (place in 0 until mesh.nodesPerElement) out.long(mesh.nodeOf(element, place) + 1)
            }
        }
        out.line("").line("\$EndElements")
    }
}
