package org.trigrid.io

/**
 * Gmsh's MSH 4.1, ASCII. One curve entity for each group and one surface, which holds all nodes: readers number nodes
 * in the order of the file, and spread over entities they would lose the order of the renumbering.
 */
internal object Msh41Writer {
    fun write(mesh: FileMesh, text: TextBuffer) {
        val groups = MeshGroups(mesh)
        text.line("\$MeshFormat").line("4.1 0 8").line("\$EndMeshFormat")
        Msh22Writer.writeNames(groups, text)
        writeEntities(mesh, groups, text)
        writeNodes(mesh, text)
        writeElements(mesh, groups, text)
    }

    private fun writeEntities(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        text.line("\$Entities").text("0 ").number(groups.curveCount).line(" 1 0")
        for (i in 0 until groups.curveCount) {
            text.number(i + 1).space()
            writeBox(MeshBox.ofCurve(mesh, groups, i), text)
            text.text(" 1 ").number(i + 1).line(" 0")
        }
        text.text("1 ")
        writeBox(MeshBox.of(mesh), text)
        val bounding = boundingCurves(mesh, groups)
        text.text(" 1 ").number(groups.regionId).space().number(bounding.size)
        for (i in bounding) text.space().number(i + 1)
        text.line().line("\$EndEntities")
    }

    /** Curve groups with an edge on the boundary. */
    fun boundingCurves(mesh: FileMesh, groups: MeshGroups): IntArray {
        val onBoundary = BooleanArray(mesh.tags.size)
        for (edge in 0 until mesh.boundaryEdgeCount) onBoundary[mesh.edgeTags[edge]] = true
        return (0 until groups.curveCount).filter { onBoundary[groups.curveTags[it]] }.toIntArray()
    }

    private fun writeBox(box: MeshBox, text: TextBuffer) {
        text.number(box.minX).space().number(box.minY).text(" 0 ").number(box.maxX).space().number(box.maxY).text(" 0")
    }

    private fun writeNodes(mesh: FileMesh, text: TextBuffer) {
        val count = mesh.nodeCount
        text.line("\$Nodes")
        text.text("1 ").number(count).text(if (count > 0) " 1 " else " 0 ").number(count).line()
        text.text("2 1 0 ").number(count).line()
        for (node in 1..count) text.number(node).line()
        for (node in 0 until count) text.number(mesh.x(node)).space().number(mesh.y(node)).text(" 0\n")
        text.line("\$EndNodes")
    }

    private fun writeElements(mesh: FileMesh, groups: MeshGroups, text: TextBuffer) {
        val count = mesh.taggedEdgeCount + mesh.elementCount
        text.line("\$Elements")
        text.number(groups.curveCount + 1).space().number(count).text(if (count > 0) " 1 " else " 0 ").number(count).line()
        var id = 1
        for (i in 0 until groups.curveCount) {
            text.text("1 ").number(i + 1).space().number(MshElements.line(mesh)).space().number(groups.size(i)).line()
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                text.number(id++)
                for (place in 0 until mesh.nodesPerEdge) text.space().number(mesh.nodeOn(edge, place) + 1)
                text.line()
            }
        }
        text.text("2 1 ").number(MshElements.triangle(mesh)).space().number(mesh.elementCount).line()
        for (element in 0 until mesh.elementCount) {
            text.number(id++)
            for (place in 0 until mesh.nodesPerElement) text.space().number(mesh.nodeOf(element, place) + 1)
            text.line()
        }
        text.line("\$EndElements")
    }
}
