package org.trigrid.io

import kotlinx.serialization.json.JsonPrimitive
import org.trigrid.mesh.TriMesh
import java.io.OutputStream

/** Arrays in JSON, all numbers from 0: nodes `[x, y]`, elements `[a, b, c]`, for each tag its edges `[a, b]` and its points; with several regions the region of each element. */
internal class MeshJsonFormat : MeshFormat("json", "arrays in JSON", listOf(".json"), canRead = false) {
    override fun write(mesh: TriMesh, out: OutputStream) {
        val text = TextBuffer(out)
        text.line("{\"format\": \"trigrid-mesh\", \"version\": 1,")
        text.text("\"region\": ").utf8(quoted(mesh.regionName)).line(",")
        text.line("\"nodes\": [")
        for (node in 0 until mesh.nodeCount) {
            text.text("[").number(mesh.x(node)).text(", ").number(mesh.y(node)).line(if (node + 1 < mesh.nodeCount) "]," else "]")
        }
        text.line("],").line("\"elements\": [")
        for (element in 0 until mesh.elementCount) {
            text.text("[").number(mesh.nodeOf(element, 0)).text(", ").number(mesh.nodeOf(element, 1))
            text.text(", ").number(mesh.nodeOf(element, 2)).line(if (element + 1 < mesh.elementCount) "]," else "]")
        }
        text.line("],")
        if (mesh.regions.size > 1) writeRegions(mesh, text)
        if (mesh.pointCount > 0) writePoints(mesh, text)
        text.line("\"edges\": {")
        writeEdges(mesh, text)
        text.line("}}")
        text.flush()
    }

    private fun writeRegions(mesh: TriMesh, text: TextBuffer) {
        text.text("\"regions\": [").utf8(mesh.regions.joinToString { quoted(it.name) }).line("],")
        text.text("\"elementRegions\": [")
        for (element in 0 until mesh.elementCount) text.text(if (element == 0) "" else ", ").number(mesh.regionOf(element))
        text.line("],")
    }

    private fun writePoints(mesh: TriMesh, text: TextBuffer) {
        val groups = MeshGroups(mesh)
        text.line("\"points\": {")
        for (group in 0 until groups.pointGroupCount) {
            val nodes = groups.points(group).joinToString { mesh.pointNode(it).toString() }
            text.utf8(quoted(mesh.tags[groups.pointTags[group]])).text(": [").text(nodes)
            text.line(if (group + 1 < groups.pointGroupCount) "]," else "]")
        }
        text.line("},")
    }

    private fun writeEdges(mesh: TriMesh, text: TextBuffer) {
        val groups = MeshGroups(mesh)
        for (curve in 0 until groups.curveCount) {
            text.utf8(quoted(mesh.tags[groups.curveTags[curve]])).text(": [")
            for (k in 0 until groups.size(curve)) {
                val edge = groups.edge(curve, k)
                text.text(if (k == 0) "[" else ", [").number(mesh.edgeStart(edge)).text(", ").number(mesh.edgeEnd(edge)).text("]")
            }
            text.line(if (curve + 1 < groups.curveCount) "]," else "]")
        }
    }

    private fun quoted(name: String) = JsonPrimitive(name).toString()
}
