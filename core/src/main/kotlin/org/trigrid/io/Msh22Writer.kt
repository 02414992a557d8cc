package org.trigrid.io

/**
 * Gmsh's MSH 2.2, ASCII: the version that most solvers read. Nodes keep their order, each element is in exactly one
 * group, lines have the domain on their left.
 */
internal object Msh22Writer {
    fun write(mesh: FileMesh, text: TextBuffer) {
        val groups = MeshGroups(mesh)
        text.line("\$MeshFormat").line("2.2 0 8").line("\$EndMeshFormat")
        writeNames(groups, text)
        text.line("\$Nodes").number(mesh.nodeCount).line()
        for (node in 0 until mesh.nodeCount) {
            text.number(node + 1).space().number(mesh.x(node)).space().number(mesh.y(node)).text(" 0\n")
        }
        text.line("\$EndNodes")
        text.line("\$Elements").number(mesh.pointCount + mesh.taggedEdgeCount + mesh.elementCount).line()
        writePoints(mesh, groups, text)
        writeLines(mesh, groups, text)
        writeTriangles(mesh, groups, text)
        text.line("\$EndElements")
    }

    /** The same section in both versions. */
    fun writeNames(groups: MeshGroups, text: TextBuffer) {
        text.line("\$PhysicalNames").number(groups.count).line()
        for (i in 0 until groups.pointGroupCount) writeName(0, groups.pointId(i), groups.pointNames[i], text)
        for (i in 0 until groups.curveCount) writeName(1, groups.curveId(i), groups.curveNames[i], text)
        for (i in 0 until groups.regionCount) writeName(2, groups.regionId(i), groups.regionNames[i], text)
        text.line("\$EndPhysicalNames")
    }

    private fun writeName(dimension: Int, id: Int, name: String, text: TextBuffer) {
        text.number(dimension).space().number(id).text(" \"").text(name).text("\"\n")
    }

    private fun writePoints(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        for (p in 0 until mesh.pointCount) {
            text.number(p + 1).space().number(MeshContents.POINT).text(" 2 ").number(groups.pointId(groups.groupOfPoint(p)))
            text.space().number(p + 1).space().number(mesh.pointNode(p) + 1).line()
        }
    }

    private fun writeLines(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        var id = mesh.pointCount + 1
        for (i in 0 until groups.curveCount) {
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                text.number(id++).space().number(MshElements.line(mesh)).text(" 2 ").number(groups.curveId(i)).space().number(i + 1)
                for (place in 0 until mesh.nodesPerEdge) text.space().number(mesh.nodeOn(edge, place) + 1)
                text.line()
            }
        }
    }

    private fun writeTriangles(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        val first = mesh.pointCount + mesh.taggedEdgeCount + 1
        val middles = List(groups.regionCount) { " ${MshElements.triangle(mesh)} 2 ${groups.regionId(it)} ${it + 1}" }
        for (element in 0 until mesh.elementCount) {
            text.number(first + element).text(middles[mesh.regionOf(element)])
            for (place in 0 until mesh.nodesPerElement) text.space().number(mesh.nodeOf(element, place) + 1)
            text.line()
        }
    }
}
