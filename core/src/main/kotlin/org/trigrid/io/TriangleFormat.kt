package org.trigrid.io

import org.trigrid.mesh.TriMesh
import java.nio.file.Files
import java.nio.file.Path

/**
 * The files of Triangle (Shewchuk 1996): `.node`, `.ele`, `.edge` with all edges, and `.poly` with the tagged ones and a point in
 * each hole. Numbers count from 1; the marker of an edge is the number of its tag from 1, 0 for those without, the attribute of
 * an element the material number of its region, and comments name them.
 */
internal class TriangleFormat : MeshFormat(
    "triangle", "Triangle .node, .ele, .edge, .poly", listOf(".ele", ".node", ".edge", ".poly"), canRead = true, isSingleFile = false,
) {
    override fun filesOf(file: Path): List<Path> = listOf(".node", ".ele", ".edge", ".poly").map { sibling(file, it) }

    override fun writeFiles(mesh: TriMesh, file: Path) {
        val groups = MeshGroups(mesh)
        val markers = EdgeMarkers(mesh)
        part(file, ".node") { writeNodes(mesh, markers, it) }
        part(file, ".ele") { writeElements(mesh, groups, it) }
        part(file, ".edge") { writeEdges(mesh, groups, markers, it) }
        part(file, ".poly") { writePoly(mesh, groups, it) }
    }

    private fun part(file: Path, ending: String, write: (TextBuffer) -> Unit) {
        AtomicFile.write(sibling(file, ending)) { out -> TextBuffer(out).let { write(it); it.flush() } }
    }

    private fun writeNodes(mesh: TriMesh, markers: EdgeMarkers, text: TextBuffer) {
        text.number(mesh.nodeCount).line(" 2 0 1")
        for (node in 0 until mesh.nodeCount) {
            text.number(node + 1).space().number(mesh.x(node)).space().number(mesh.y(node)).space().number(markers.ofNode(node)).line()
        }
    }

    private fun writeElements(mesh: TriMesh, groups: MeshGroups, text: TextBuffer) {
        for (r in 0 until groups.regionCount) {
            text.text("# attribute ").number(groups.material(r)).text(": ").line(groups.regionNames[r])
        }
        text.number(mesh.elementCount).line(" 3 1")
        for (element in 0 until mesh.elementCount) {
            text.number(element + 1)
            for (corner in 0..2) text.space().number(mesh.nodeOf(element, corner) + 1)
            text.space().number(groups.material(mesh.regionOf(element))).line()
        }
    }

    private fun writeEdges(mesh: TriMesh, groups: MeshGroups, markers: EdgeMarkers, text: TextBuffer) {
        writeNames(groups, text)
        val edges = mesh.edgeNodes()
        text.number(edges.size / 2).line(" 1")
        for (edge in 0 until edges.size / 2) {
            val a = edges[2 * edge]
            val b = edges[2 * edge + 1]
            text.number(edge + 1).space().number(a + 1).space().number(b + 1).space().number(markers.ofEdge(a, b)).line()
        }
    }

    private fun writePoly(mesh: TriMesh, groups: MeshGroups, text: TextBuffer) {
        writeNames(groups, text)
        text.line("0 2 0 1").number(mesh.taggedEdgeCount).line(" 1")
        var id = 1
        for (curve in 0 until groups.curveCount) {
            for (k in 0 until groups.size(curve)) {
                val edge = groups.edge(curve, k)
                text.number(id++).space().number(mesh.edgeStart(edge) + 1).space().number(mesh.edgeEnd(edge) + 1)
                text.space().number(groups.curveTags[curve] + 1).line()
            }
        }
        val outline = mesh.outline()
        PolyFormat.writeHoles(HolePoints.of(outline), text)
        PolyFormat.writeRegions(outline, text)
    }

    private fun writeNames(groups: MeshGroups, text: TextBuffer) {
        for (curve in 0 until groups.curveCount) {
            text.text("# marker ").number(groups.curveTags[curve] + 1).text(": ").line(groups.curveNames[curve])
        }
    }

    override fun readEither(file: Path): ReadMesh {
        val edges = listOf(sibling(file, ".poly"), sibling(file, ".edge")).firstOrNull { Files.exists(it) }
        return TriangleReader(sibling(file, ".node"), sibling(file, ".ele"), edges).read()
    }
}

/** Tags of edges and nodes as markers: the tag's number + 1, 0 without a tag. */
private class EdgeMarkers(mesh: TriMesh) {
    private val first = IntArray(mesh.nodeCount) { -1 }
    private val next = IntArray(mesh.taggedEdgeCount)
    private val nodeMarkers = IntArray(mesh.nodeCount)
    private val mesh = mesh

    init {
        for (p in 0 until mesh.pointCount) nodeMarkers[mesh.pointNode(p)] = mesh.pointTag(p) + 1
        for (edge in mesh.taggedEdgeCount - 1 downTo 0) {
            val low = minOf(mesh.edgeStart(edge), mesh.edgeEnd(edge))
            next[edge] = first[low]
            first[low] = edge
            nodeMarkers[mesh.edgeStart(edge)] = mesh.edgeTag(edge) + 1
            nodeMarkers[mesh.edgeEnd(edge)] = mesh.edgeTag(edge) + 1
        }
    }

    fun ofNode(node: Int): Int = nodeMarkers[node]

    /** @param a the lower node. */
    fun ofEdge(a: Int, b: Int): Int {
        var edge = first[a]
        while (edge >= 0 && maxOf(mesh.edgeStart(edge), mesh.edgeEnd(edge)) != b) edge = next[edge]
        return if (edge < 0) 0 else mesh.edgeTag(edge) + 1
    }
}
