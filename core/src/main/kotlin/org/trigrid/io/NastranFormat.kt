package org.trigrid.io

import java.io.OutputStream

/**
 * Nastran bulk data: GRID* with fields of 16 characters, CTRIA3 or CTRIA6 with the material number of its region for a property id, and for each tag a SET1 of
 * its nodes, which a comment names. Of a coordinate as many digits are kept as fit: 15, and 14 below 0.
 */
internal class NastranFormat : MeshFormat("nastran", "Nastran bulk data", listOf(".bdf", ".nas"), canRead = false, highestOrder = 2) {
    override fun write(mesh: FileMesh, out: OutputStream) {
        val text = TextBuffer(out)
        val groups = MeshGroups(mesh)
        text.line("$ mesh of TriGrid").line("BEGIN BULK")
        for (r in 0 until groups.regionCount) text.line("$ property ${groups.material(r)}: ${groups.regionNames[r]}")
        val decimal = DecimalText()
        for (node in 0 until mesh.nodeCount) {
            text.text("GRID*   ").text((node + 1).toString().padEnd(LARGE)).text(" ".repeat(LARGE))
            text.text(decimal.nastran(mesh.x(node), LARGE).padStart(LARGE))
            text.text(decimal.nastran(mesh.y(node), LARGE).padStart(LARGE)).line()
            text.text("*       ").line("0.".padStart(LARGE))
        }
        for (element in 0 until mesh.elementCount) {
            text.text(if (mesh.order == 2) "CTRIA6  " else "CTRIA3  ")
            writeSmall(element + 1, text)
            writeSmall(groups.material(mesh.regionOf(element)), text)
            for (place in 0 until mesh.nodesPerElement) writeSmall(mesh.nodeOf(element, place) + 1, text)
            text.line()
        }
        for (curve in 0 until groups.curveCount) {
            text.line("$ set ${curve + 1}: ${groups.curveNames[curve]}")
            writeSet(curve + 1, groups.nodes(mesh, curve), text)
        }
        for (group in 0 until groups.pointGroupCount) {
            val id = groups.curveCount + group + 1
            text.line("$ set $id: ${groups.pointNames[group]}")
            writeSet(id, groups.pointNodes(mesh, group), text)
        }
        text.line("ENDDATA")
        text.flush()
    }

    private fun writeSet(id: Int, nodes: IntArray, text: TextBuffer) {
        text.text("SET1    ")
        writeSmall(id, text)
        for (i in nodes.indices) {
            // Eight fields a line, the first line's first taken by the id.
            if (i % FIELDS == FIELDS - 1) text.line().text("+       ")
            writeSmall(nodes[i] + 1, text)
        }
        text.line()
    }

    private fun writeSmall(value: Int, text: TextBuffer) {
        text.text(value.toString().padEnd(SMALL))
    }

    private companion object {
        const val SMALL = 8
        const val LARGE = 16
        const val FIELDS = 8
    }
}
