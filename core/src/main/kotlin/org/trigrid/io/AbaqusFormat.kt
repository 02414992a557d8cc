package org.trigrid.io

import org.trigrid.mesh.TaggedSides
import java.io.OutputStream

/**
 * Input files of Abaqus and CalculiX: nodes, elements CPS3 or CPS6 (plane stress) in a set for each region, and for each tag a node set, a set of the
 * elements along it and, where it is on the boundary, a surface of their edges.
 */
internal class AbaqusFormat : MeshFormat("abaqus", "Abaqus and CalculiX input", listOf(".inp"), canRead = false, highestOrder = 2) {
    override fun write(mesh: FileMesh, out: OutputStream) {
        val text = TextBuffer(out)
        val groups = MeshGroups(mesh, GroupNames.ABAQUS)
        text.line("*HEADING").line("mesh of TriGrid")
        writeNodes(mesh, text)
        for (region in 0 until groups.regionCount) {
            text.text("*ELEMENT, TYPE=CPS").number(mesh.nodesPerElement).text(", ELSET=").line(groups.regionNames[region])
            for (element in groups.elements(region)) {
                text.number(element + 1)
                for (place in 0 until mesh.nodesPerElement) text.text(", ").number(mesh.nodeOf(element, place) + 1)
                text.line()
            }
        }
        val sides = TaggedSides(mesh.nodeCount, mesh.elements, mesh.nodesPerElement, mesh.edges, mesh.nodesPerEdge)
        for (curve in 0 until groups.curveCount) writeSets(mesh, groups, sides, curve, text)
        for (group in 0 until groups.pointGroupCount) {
            text.text("*NSET, NSET=").line(groups.pointNames[group])
            writeNumbers(groups.pointNodes(mesh, group), text)
        }
        text.flush()
    }

    /** CalculiX reads the first 20 characters of a number. */
    private fun writeNodes(mesh: FileMesh, text: TextBuffer) {
        val decimal = DecimalText()
        text.line("*NODE, NSET=Nall")
        for (node in 0 until mesh.nodeCount) {
            text.number(node + 1)
            text.text(", ").text(decimal.fitting(mesh.x(node), NUMBER_WIDTH))
            text.text(", ").text(decimal.fitting(mesh.y(node), NUMBER_WIDTH)).line(", 0")
        }
    }

    private fun writeSets(mesh: FileMesh, groups: MeshGroups, sides: TaggedSides, curve: Int, text: TextBuffer) {
        val name = groups.curveNames[curve]
        text.text("*NSET, NSET=").line(name)
        writeNumbers(groups.nodes(mesh, curve), text)
        val halves = (0 until groups.size(curve)).map { sides.leftOf(groups.edge(curve, it)) }.sorted()
        text.text("*ELSET, ELSET=").line(elementSet(name, groups))
        writeNumbers(halves.map { it / 3 }.distinct().toIntArray(), text)
        if ((0 until groups.size(curve)).any { groups.edge(curve, it) >= mesh.boundaryEdgeCount }) return
        text.text("*SURFACE, TYPE=ELEMENT, NAME=").line(name)
        for (half in halves) text.number(half / 3 + 1).text(", S").number(half % 3 + 1).line()
    }

    private fun elementSet(name: String, groups: MeshGroups): String {
        val wanted = name + "_elements"
        return if (groups.regionNames.any { wanted.equals(it, ignoreCase = true) }) name + "_elements_2" else wanted
    }

    private fun writeNumbers(zeroBased: IntArray, text: TextBuffer) {
        for (i in zeroBased.indices) {
            text.number(zeroBased[i] + 1)
            if (i % PER_LINE == PER_LINE - 1 || i == zeroBased.lastIndex) text.line() else text.text(", ")
        }
    }

    private companion object {
        const val NUMBER_WIDTH = 20
        const val PER_LINE = 16
    }
}
