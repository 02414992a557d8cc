package org.trigrid.io

import org.trigrid.mesh.TriMesh

/**
 * Gmsh's MSH 4.1, ASCII. One curve entity for each group and one surface, which holds all nodes: readers number nodes
 * in the order of the file, and spread over entities they would lose the order of the renumbering.
 */
internal object Msh41Writer {
    fun write(mesh: TriMesh, text: TextBuffer) {
        val groups = MshGroups(mesh)
        text.line("\$MeshFormat").line("4.1 0 8").line("\$EndMeshFormat")
        Msh22Writer.writeNames(groups, text)
        writeEntities(mesh, groups, text)
        writeNodes(mesh, text)
        writeElements(mesh, groups, text)
    }

    private fun writeEntities(mesh: TriMesh, groups: MshGroups, text: TextBuffer) {
        text.line("\$Entities").text("0 ").number(groups.curveCount).line(" 1 0")
        val onBoundary = BooleanArray(mesh.tags.size)
        for (edge in 0 until mesh.boundaryEdgeCount) onBoundary[mesh.edgeTag(edge)] = true
        for (i in 0 until groups.curveCount) {
            val box = Box()
            for (edge in 0 until mesh.taggedEdgeCount) {
                if (mesh.edgeTag(edge) != groups.curveTags[i]) continue
                box.add(mesh, mesh.edgeStart(edge))
                box.add(mesh, mesh.edgeEnd(edge))
            }
            text.number(i + 1).space()
            box.write(text)
            text.text(" 1 ").number(i + 1).line(" 0")
        }
        val whole = Box()
        for (node in 0 until mesh.nodeCount) whole.add(mesh, node)
        text.text("1 ")
        whole.write(text)
        val bounding = (0 until groups.curveCount).filter { onBoundary[groups.curveTags[it]] }
        text.text(" 1 ").number(groups.surfaceId).space().number(bounding.size)
        for (i in bounding) text.space().number(i + 1)
        text.line().line("\$EndEntities")
    }

    private fun writeNodes(mesh: TriMesh, text: TextBuffer) {
        val count = mesh.nodeCount
        text.line("\$Nodes")
        text.text("1 ").number(count).text(if (count > 0) " 1 " else " 0 ").number(count).line()
        text.text("2 1 0 ").number(count).line()
        for (node in 1..count) text.number(node).line()
        for (node in 0 until count) text.number(mesh.x(node)).space().number(mesh.y(node)).text(" 0\n")
        text.line("\$EndNodes")
    }

    private fun writeElements(mesh: TriMesh, groups: MshGroups, text: TextBuffer) {
        val count = mesh.taggedEdgeCount + mesh.elementCount
        text.line("\$Elements")
        text.number(groups.curveCount + 1).space().number(count).text(if (count > 0) " 1 " else " 0 ").number(count).line()
        var id = 1
        for (i in 0 until groups.curveCount) {
            text.text("1 ").number(i + 1).text(" 1 ").number(groups.curveSizes[i]).line()
            for (edge in 0 until mesh.taggedEdgeCount) {
                if (mesh.edgeTag(edge) != groups.curveTags[i]) continue
                text.number(id++).space().number(mesh.edgeStart(edge) + 1).space().number(mesh.edgeEnd(edge) + 1).line()
            }
        }
        text.text("2 1 2 ").number(mesh.elementCount).line()
        for (element in 0 until mesh.elementCount) {
            text.number(id++).space().number(mesh.nodeOf(element, 0) + 1).space()
            text.number(mesh.nodeOf(element, 1) + 1).space().number(mesh.nodeOf(element, 2) + 1).line()
        }
        text.line("\$EndElements")
    }

    /** The box round some nodes. */
    private class Box {
        private var minX = Double.POSITIVE_INFINITY
        private var minY = Double.POSITIVE_INFINITY
        private var maxX = Double.NEGATIVE_INFINITY
        private var maxY = Double.NEGATIVE_INFINITY

        fun add(mesh: TriMesh, node: Int) {
            minX = minOf(minX, mesh.x(node))
            minY = minOf(minY, mesh.y(node))
            maxX = maxOf(maxX, mesh.x(node))
            maxY = maxOf(maxY, mesh.y(node))
        }

        fun write(text: TextBuffer) {
            if (minX > maxX) {
                text.text("0 0 0 0 0 0")
                return
            }
            text.number(minX).space().number(minY).text(" 0 ").number(maxX).space().number(maxY).text(" 0")
        }
    }
}
