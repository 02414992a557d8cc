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
        text.line("\$Elements").number(mesh.taggedEdgeCount + mesh.elementCount).line()
        writeLines(mesh, groups, text)
        writeTriangles(mesh, groups, text)
        text.line("\$EndElements")
    }

    /** The same section in both versions. */
    fun writeNames(groups: MeshGroups, text: TextBuffer) {
        text.line("\$PhysicalNames").number(groups.curveCount + 1).line()
        for (i in 0 until groups.curveCount) {
            text.text("1 ").number(i + 1).text(" \"").text(groups.curveNames[i]).text("\"\n")
        }
        text.text("2 ").number(groups.regionId).text(" \"").text(groups.regionName).text("\"\n")
        text.line("\$EndPhysicalNames")
    }

    private fun writeLines(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        var id = 1
        for (i in 0 until groups.curveCount) {
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                text.number(id++).space().number(MshElements.line(mesh)).text(" 2 ").number(i + 1).space().number(i + 1)
                for (place in 0 until mesh.nodesPerEdge) text.space().number(mesh.nodeOn(edge, place) + 1)
                text.line()
            }
        }
    }

    private fun writeTriangles(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        val first = mesh.taggedEdgeCount + 1
        val middle = " ${MshElements.triangle(mesh)} 2 ${groups.regionId} 1"
        for (element in 0 until mesh.elementCount) {
            text.number(first + element).text(middle)
            for (place in 0 until mesh.nodesPerElement) text.space().number(mesh.nodeOf(element, place) + 1)
            text.line()
        }
    }
}
