package org.trigrid.io

/**
 * Gmsh's MSH 4.1, ASCII. One curve entity for each group of edges, one surface for each region, one point entity for each
 * point. The first surface holds all nodes: readers number nodes in the order of the file, and spread over entities they would
 * lose the order of the renumbering. Elements come region by region.
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
        text.line("\$Entities").number(mesh.pointCount).space().number(groups.curveCount).space().number(groups.regionCount).line(" 0")
        for (p in 0 until mesh.pointCount) {
            text.number(p + 1).space().number(mesh.x(mesh.pointNode(p))).space().number(mesh.y(mesh.pointNode(p)))
            text.text(" 0 1 ").number(groups.pointId(groups.groupOfPoint(p))).line()
        }
        for (i in 0 until groups.curveCount) {
            text.number(i + 1).space()
            writeBox(MeshBox.ofCurve(mesh, groups, i), text)
            text.text(" 1 ").number(groups.curveId(i)).line(" 0")
        }
        val bounding = BoundingCurves(mesh, groups)
        for (region in 0 until groups.regionCount) {
            text.number(region + 1).space()
            writeBox(MeshBox.ofRegion(mesh, region), text)
            val curves = bounding.of(region)
            text.text(" 1 ").number(groups.regionId(region)).space().number(curves.size)
            for (i in curves) text.space().number(i + 1)
            text.line()
        }
        text.line("\$EndEntities")
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
        val count = mesh.pointCount + mesh.taggedEdgeCount + mesh.elementCount
        text.line("\$Elements")
        val blocks = mesh.pointCount + groups.curveCount + groups.regionCount
        text.number(blocks).space().number(count).text(if (count > 0) " 1 " else " 0 ").number(count).line()
        for (p in 0 until mesh.pointCount) {
            text.text("0 ").number(p + 1).space().number(MeshContents.POINT).line(" 1")
            text.number(p + 1).space().number(mesh.pointNode(p) + 1).line()
        }
        var id = mesh.pointCount + 1
        for (i in 0 until groups.curveCount) {
            text.text("1 ").number(i + 1).space().number(MshElements.line(mesh)).space().number(groups.size(i)).line()
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                text.number(id++)
                for (place in 0 until mesh.nodesPerEdge) text.space().number(mesh.nodeOn(edge, place) + 1)
                text.line()
            }
        }
        for (region in 0 until groups.regionCount) {
            val elements = groups.elements(region)
            text.text("2 ").number(region + 1).space().number(MshElements.triangle(mesh)).space().number(elements.size).line()
            for (element in elements) {
                text.number(id++)
                for (place in 0 until mesh.nodesPerElement) text.space().number(mesh.nodeOf(element, place) + 1)
                text.line()
            }
        }
        text.line("\$EndElements")
    }
}
