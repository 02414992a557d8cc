package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.nio.file.Path

/** Three tables with a line of headings each, all numbers from 0: `.nodes.csv`, `.elements.csv`, `.edges.csv`. */
internal class MeshCsvFormat : MeshFormat(
    "csv", "tables of nodes, elements and edges", listOf(".csv", ".nodes.csv", ".elements.csv", ".edges.csv"), canRead = false,
    isSingleFile = false,
) {
    override fun filesOf(file: Path): List<Path> = endings.drop(1).map { sibling(file, it) }

    override fun writeFiles(mesh: TriMesh, file: Path) {
        table(file, ".nodes.csv") { text ->
            text.line("node,x,y")
            for (node in 0 until mesh.nodeCount) text.number(node).text(",").number(mesh.x(node)).text(",").number(mesh.y(node)).line()
        }
        table(file, ".elements.csv") { text ->
            val regions = mesh.regions.map { quoted(it.name) }
            text.line("element,a,b,c,region")
            for (element in 0 until mesh.elementCount) {
                text.number(element)
                for (corner in 0..2) text.text(",").number(mesh.nodeOf(element, corner))
                text.text(",").utf8(regions[mesh.regionOf(element)]).line()
            }
        }
        table(file, ".edges.csv") { text ->
            text.line("a,b,tag,embedded")
            for (edge in 0 until mesh.taggedEdgeCount) {
                text.number(mesh.edgeStart(edge)).text(",").number(mesh.edgeEnd(edge)).text(",")
                text.utf8(quoted(mesh.tags[mesh.edgeTag(edge)])).line(if (edge < mesh.boundaryEdgeCount) ",0" else ",1")
            }
        }
    }

    private fun table(file: Path, ending: String, write: (TextBuffer) -> Unit) {
        AtomicFile.write(sibling(file, ending)) { out -> TextBuffer(out).let { write(it); it.flush() } }
    }

    /** As RFC 4180 quotes. */
    private fun quoted(name: String): String =
        if (name.any { it == ',' || it == '"' || it < ' ' }) "\"" + name.replace("\"", "\"\"") + "\"" else name
}
