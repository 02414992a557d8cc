package org.trigrid.io

import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * Medit's `.mesh`, ASCII, in two dimensions. The reference of an edge is the number of its tag from 1, that of a triangle the
 * material number of its region, that of a vertex the number of its point group from 1, 0 for none; comments name them.
 */
internal class MeditFormat : MeshFormat("medit", "Medit .mesh, ASCII", listOf(".mesh"), canRead = true, highestOrder = 2) {
    override fun write(mesh: FileMesh, out: OutputStream) {
        val text = TextBuffer(out)
        val groups = MeshGroups(mesh)
        text.line("MeshVersionFormatted 2").line("Dimension 2")
        for (i in 0 until groups.curveCount) text.text("# edges ").number(i + 1).text(": ").line(groups.curveNames[i])
        for (r in 0 until groups.regionCount) text.text("# triangles ").number(groups.material(r)).text(": ").line(groups.regionNames[r])
        for (i in 0 until groups.pointGroupCount) text.text("# vertices ").number(i + 1).text(": ").line(groups.pointNames[i])
        text.line("Vertices").number(mesh.nodeCount).line()
        val references = IntArray(mesh.nodeCount)
        for (p in 0 until mesh.pointCount) references[mesh.pointNode(p)] = groups.groupOfPoint(p) + 1
        for (node in 0 until mesh.nodeCount) {
            text.number(mesh.x(node)).space().number(mesh.y(node)).space().number(references[node]).line()
        }
        text.line(if (mesh.order == 2) "EdgesP2" else "Edges").number(mesh.taggedEdgeCount).line()
        for (i in 0 until groups.curveCount) {
            for (k in 0 until groups.size(i)) {
                val edge = groups.edge(i, k)
                for (place in 0 until mesh.nodesPerEdge) text.number(mesh.nodeOn(edge, place) + 1).space()
                text.number(i + 1).line()
            }
        }
        text.line(if (mesh.order == 2) "TrianglesP2" else "Triangles").number(mesh.elementCount).line()
        for (element in 0 until mesh.elementCount) {
            for (place in 0 until mesh.nodesPerElement) text.number(mesh.nodeOf(element, place) + 1).space()
            text.number(groups.material(mesh.regionOf(element))).line()
        }
        text.line("End")
        text.flush()
    }

    override fun readEither(file: Path): ReadMesh {
        ReadingMemory.check(file, ReadingMemory.MSH)
        return MeditReader.read(Files.readAllBytes(file), file.toString())
    }
}

/** Reads triangles and edges of a Medit file; a reference r names "ref_r". */
internal class MeditReader private constructor(private val scanner: MshScanner) {
    private val contents = MeshContents(scanner, "ref_", "ref_")
    private var dimension = 0
    private var vertexCount = -1

    private fun read(): ReadMesh {
        scanner.expect("MeshVersionFormatted")
        scanner.int("the version", 1)
        while (!scanner.atEnd()) {
            when (val keyword = scanner.word("a keyword")) {
                "Dimension" -> dimension = scanner.int("the dimension", 2)
                "Vertices" -> readVertices()
                "Edges", "EdgesP2" -> readEdges(keyword == "EdgesP2")
                "Triangles", "TrianglesP2" -> readTriangles(keyword == "TrianglesP2")
                "Quadrilaterals", "Tetrahedra", "Hexahedra", "Prisms", "Pyramids" -> {
                    if (scanner.int("the number of elements", 0) > 0) scanner.fail("$keyword cannot be read, only Edges and Triangles")
                }
                "End" -> break
                else -> {
                    if (!keyword[0].isLetter()) scanner.fail("expected a keyword such as Vertices, found '$keyword'")
                    scanner.skipNumbers()
                }
            }
        }
        return contents.toMesh()
    }

    private fun readVertices() {
        if (dimension !in 2..3) scanner.fail("vertices before a Dimension of 2 or 3")
        if (vertexCount >= 0) scanner.fail("a second section of vertices")
        vertexCount = scanner.count("the number of vertices")
        contents.expectNodes(vertexCount)
        for (i in 1..vertexCount) {
            val node = contents.addNode(i)
            val x = scanner.double("x")
            val y = scanner.double("y")
            contents.place(node, x, y, if (dimension == 3) scanner.double("z") else 0.0)
            scanner.int("a reference", Int.MIN_VALUE)
        }
        contents.closeNodes()
    }

    private fun readEdges(haveMiddles: Boolean) {
        repeat(scanner.count("the number of edges")) {
            val a = vertex()
            val b = vertex()
            if (haveMiddles) vertex()
            contents.addLine(a, b, reference())
        }
    }

    private fun readTriangles(haveMiddles: Boolean) {
        repeat(scanner.count("the number of triangles")) {
            val nodes = IntArray(if (haveMiddles) 6 else 3) { vertex() }
            contents.addTriangle(nodes[0], nodes[1], nodes[2], reference())
            if (haveMiddles) contents.addMiddles(nodes[3], nodes[4], nodes[5])
        }
    }

    private fun vertex(): Int = contents.nodeOf(scanner.int("a vertex", 1))

    private fun reference(): Int = Math.abs(scanner.int("a reference", -Int.MAX_VALUE))

    companion object {
        /**
         * @param source name of the file, for messages.
         * @throws org.trigrid.diagnostics.FileFormatException with line and column.
         */
        fun read(bytes: ByteArray, source: String): ReadMesh = MeditReader(MshScanner(bytes, source, '#')).read()
    }
}
