package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.IOException
import java.nio.file.Path

/**
 * Reads a mesh of Triangle's: `.node` and `.ele`, and the markers of edges from `.poly` or `.edge` where one is there. An edge
 * with the marker m gets the tag "marker_m"; the first attribute of the elements numbers their region.
 */
internal class TriangleReader(
    private val nodeFile: Path,
    private val elementFile: Path,
    /** `.poly` or `.edge`, which name edges in the same way, or null. */
    private val edgeFile: Path?,
) {
    /** What is being read, for complaints. */
    private lateinit var current: PolyLines

    @Throws(IOException::class)
    fun read(): ReadMesh = read(textOf(nodeFile), textOf(elementFile), edgeFile?.let { textOf(it) })

    private fun textOf(file: Path): String {
        ReadingMemory.check(file, ReadingMemory.POLY)
        return DomainFormats.textOf(file)
    }

    fun read(nodes: String, elements: String, edges: String?): ReadMesh {
        val complaint = Complaint { reason -> throw FileFormatException(current.source, current.lineNumber, 0, reason) }
        val contents = MeshContents(complaint, "marker_", "region_")
        current = PolyLines(nodeFile.toString(), nodes)
        readNodes(current, contents)
        if (edges != null) {
            current = PolyLines(edgeFile.toString(), edges)
            readEdges(current, contents)
        }
        current = PolyLines(elementFile.toString(), elements)
        readElements(current, contents)
        return contents.toMesh()
    }

    private fun readNodes(lines: PolyLines, contents: MeshContents) {
        lines.next("the number of nodes")
        val count = lines.count(0, "nodes")
        if (lines.fieldCount > 1 && lines.int(1) != 2) lines.fail(1, "nodes must have two coordinates")
        contents.expectNodes(count)
        val seen = HashSet<Int>(2 * count)
        for (i in 0 until count) {
            lines.next("node ${i + 1} of $count")
            val id = lines.int(0)
            if (id < 0) lines.fail(0, "a number of a node must not be below 0")
            if (!seen.add(id)) lines.fail(0, "there is a node of that number already")
            contents.place(contents.addNode(id), lines.double(1), lines.double(2), 0.0)
        }
        contents.closeNodes()
    }

    private fun readEdges(lines: PolyLines, contents: MeshContents) {
        lines.next("the number of edges")
        if (edgeFile.toString().endsWith(".poly")) {
            if (lines.count(0, "nodes") != 0) return
            lines.next("the number of segments")
        }
        val count = lines.count(0, "edges")
        for (i in 0 until count) {
            lines.next("edge ${i + 1} of $count")
            val marker = if (lines.fieldCount > 3) lines.int(3) else 0
            if (marker <= 0) continue
            val a = lines.int(1)
            val b = lines.int(2)
            for (end in 1..2) if (lines.int(end) < 0) lines.fail(end, "there is no such node")
            contents.addLine(contents.nodeOf(a), contents.nodeOf(b), marker)
        }
    }

    private fun readElements(lines: PolyLines, contents: MeshContents) {
        lines.next("the number of elements")
        val count = lines.count(0, "elements")
        if (lines.fieldCount > 1 && lines.int(1) != 3) lines.fail(1, "only elements of three nodes can be read")
        val hasRegion = lines.fieldCount > 2 && lines.int(2) > 0
        for (i in 0 until count) {
            lines.next("element ${i + 1} of $count")
            val nodes = IntArray(3) {
                val id = lines.int(1 + it)
                if (id < 0) lines.fail(1 + it, "there is no such node")
                contents.nodeOf(id)
            }
            val region = if (hasRegion) lines.double(4).toInt() else 0
            contents.addTriangle(nodes[0], nodes[1], nodes[2], maxOf(region, 0))
        }
    }
}
