package org.trigrid.io

/** Gmsh's MSH 2.2, binary: as [Msh22Writer], with nodes and elements as numbers of 4 and 8 bytes. */
internal object Msh22BinaryWriter {
    fun write(mesh: FileMesh, out: BinaryBuffer) {
        val groups = MeshGroups(mesh)
        out.line("\$MeshFormat").line("2.2 1 8").int(1).line("").line("\$EndMeshFormat")
        writeNames(groups, out)
        out.line("\$Nodes").line(mesh.nodeCount.toString())
        for (node in 0 until mesh.nodeCount) out.int(node + 1).double(mesh.x(node)).double(mesh.y(node)).double(0.0)
        out.line("").line("\$EndNodes")
        out.line("\$Elements").line((mesh.pointCount + mesh.taggedEdgeCount + mesh.elementCount).toString())
        writeElements(mesh, groups, out)
        out.line("").line("\$EndElements")
    }

    /** The same section in both versions, text also in binary files. */
    fun writeNames(groups: MeshGroups, out: BinaryBuffer) {
        out.line("\$PhysicalNames").line(groups.count.toString())
        for (i in 0 until groups.pointGroupCount) out.line("0 ${groups.pointId(i)} \"${groups.pointNames[i]}\"")
        for (i in 0 until groups.curveCount) out.line("1 ${groups.curveId(i)} \"${groups.curveNames[i]}\"")
        for (i in 0 until groups.regionCount) out.line("2 ${groups.regionId(i)} \"${groups.regionNames[i]}\"")
        out.line("\$EndPhysicalNames")
    }

    private fun writeElements(mesh: FileMesh, groups: MeshGroups, out: BinaryBuffer) {
        var id = 1
        if (mesh.pointCount > 0) out.int(MeshContents.POINT).int(mesh.pointCount).int(2)
        for (p in 0 until mesh.pointCount) {
            out.int(id++).int(groups.pointId(groups.groupOfPoint(p))).int(p + 1).int(mesh.pointNode(p) + 1)
        }
        for (i in 0 until groups.curveCount) {
            out.int(MshElements.line(mesh)).int(groups.size(i)).int(2)
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                out.int(id++).int(groups.curveId(i)).int(i + 1)
                for (place in 0 until mesh.nodesPerEdge) out.int(mesh.nodeOn(edge, place) + 1)
            }
        }
        if (mesh.elementCount == 0) return
        out.int(MshElements.triangle(mesh)).int(mesh.elementCount).int(2)
        for (element in 0 until mesh.elementCount) {
            out.int(id++).int(groups.regionId(mesh.regionOf(element))).int(mesh.regionOf(element) + 1)
            for (place in 0 until mesh.nodesPerElement) out.int(mesh.nodeOf(element, place) + 1)
        }
    }
}
