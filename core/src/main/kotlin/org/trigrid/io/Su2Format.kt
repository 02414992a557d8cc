package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.io.OutputStream

/** SU2's native format: a marker for each tag of the boundary; embedded edges have no place in it. Numbers count from 0. */
internal class Su2Format : MeshFormat("su2", "SU2", listOf(".su2"), canRead = false) {
    override fun write(mesh: TriMesh, out: OutputStream) {
        val text = TextBuffer(out)
        text.line("NDIME= 2").text("NELEM= ").number(mesh.elementCount).line()
        for (element in 0 until mesh.elementCount) {
            text.number(TRIANGLE)
            for (corner in 0..2) text.space().number(mesh.nodeOf(element, corner))
            text.space().number(element).line()
        }
        text.text("NPOIN= ").number(mesh.nodeCount).line()
        for (node in 0 until mesh.nodeCount) {
            text.number(mesh.x(node)).space().number(mesh.y(node)).space().number(node).line()
        }
        writeMarkers(mesh, text)
        text.flush()
    }

    private fun writeMarkers(mesh: TriMesh, text: TextBuffer) {
        val groups = MeshGroups(mesh, GroupNames.WORD)
        val edges = (0 until groups.curveCount).map { curve ->
            (0 until groups.size(curve)).map { groups.edge(curve, it) }.filter { it < mesh.boundaryEdgeCount }
        }
        text.text("NMARK= ").number(edges.count { it.isNotEmpty() }).line()
        for (curve in edges.indices) {
            if (edges[curve].isEmpty()) continue
            text.text("MARKER_TAG= ").line(groups.curveNames[curve]).text("MARKER_ELEMS= ").number(edges[curve].size).line()
            for (edge in edges[curve]) {
                text.number(LINE).space().number(mesh.edgeStart(edge)).space().number(mesh.edgeEnd(edge)).line()
            }
        }
    }

    private companion object {
        const val LINE = 3
        const val TRIANGLE = 5
    }
}
