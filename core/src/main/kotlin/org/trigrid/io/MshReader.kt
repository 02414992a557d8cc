package org.trigrid.io

/** Gmsh's mesh files, versions 2.0 to 2.2 and 4.1, ASCII and binary. */
internal class MshReader private constructor(private val scanner: MshScanner) {
    private val contents = MeshContents(scanner)
    private var is4 = false
    private var isBinary = false

    /** Physical group of entities by dimension and tag; MSH 4.1 only. */
    private val entityGroups = HashMap<Long, Int>()

    private fun read(): ReadMesh {
        if (scanner.atEnd()) scanner.fail("the file is empty")
        scanner.expect("\$MeshFormat")
        readFormat()
        var nodesSeen = false
        while (!scanner.atEnd()) {
            when (val section = scanner.word("a section")) {
                "\$PhysicalNames" -> readNames()
                "\$Entities" -> if (is4) inBinary { readEntities() } else scanner.skipTo("\$EndEntities")
                "\$Nodes" -> {
                    if (nodesSeen) scanner.fail("a second section of nodes")
                    nodesSeen = true
                    if (is4) inBinary { readNodes4() } else readNodes2()
                }
                "\$Elements" -> {
                    if (!nodesSeen) scanner.fail("elements before the nodes")
                    if (is4) inBinary { readElements4() } else readElements2()
                }
                "\$PartitionedEntities" -> scanner.fail("partitioned meshes cannot be read")
                else -> {
                    if (!section.startsWith("$")) scanner.fail("expected a section such as \$Nodes, found '$section'")
                    scanner.skipTo("\$End" + section.drop(1))
                }
            }
        }
        return contents.toMesh()
    }

    private fun readFormat() {
        val version = scanner.word("the version")
        is4 = version == "4.1"
        if (!is4 && version !in listOf("2", "2.0", "2.1", "2.2")) {
            scanner.fail("MSH version $version cannot be read, only 2.2 and 4.1")
        }
        val fileType = scanner.int("the file type", 0)
        if (fileType > 1) scanner.fail("the file type must be 0 (ASCII) or 1 (binary), not $fileType")
        isBinary = fileType == 1
        val numberSize = scanner.int("the size of a number", 1)
        if (isBinary) {
            if (numberSize != Double.SIZE_BYTES) scanner.fail("binary files with numbers of $numberSize bytes cannot be read, only of 8")
            scanner.readByteOrder()
        }
        scanner.expect("\$EndMeshFormat")
    }

    /** Reads numbers that in a binary file begin after the end of this line; counts have 8 bytes in MSH 4.1. */
    private inline fun inBinary(read: () -> Unit) {
        if (isBinary) scanner.startBinary(if (is4) Long.SIZE_BYTES else Int.SIZE_BYTES)
        read()
        scanner.endBinary()
    }

    private fun readNames() {
        repeat(scanner.int("the number of names", 0)) {
            val dimension = scanner.int("a dimension", 0)
            val id = scanner.int("a physical group", 0)
            val text = scanner.restOfLine()
            if (text.length < 2 || text.first() != '"' || text.last() != '"') scanner.fail("expected a name in quotes, found '$text'")
            contents.putName(dimension, id, text.substring(1, text.length - 1))
        }
        scanner.expect("\$EndPhysicalNames")
    }

    private fun readNodes2() {
        val count = scanner.count("the number of nodes")
        contents.expectNodes(count)
        inBinary {
            repeat(count) {
                val node = contents.addNode(scanner.int("a node id", 1))
                readPlace(node)
            }
        }
        contents.closeNodes()
        scanner.expect("\$EndNodes")
    }

    private fun readPlace(node: Int) {
        val x = scanner.double("x")
        val y = scanner.double("y")
        contents.place(node, x, y, scanner.double("z"))
    }

    private fun readElements2() {
        val count = scanner.int("the number of elements", 0)
        inBinary { if (isBinary) readBlocks2(count) else repeat(count) { readElement2() } }
        scanner.expect("\$EndElements")
    }

    private fun readElement2() {
        scanner.int("an element id", 1)
        val type = scanner.int("an element type", 1)
        readNodesOf(type, readGroup2(scanner.int("the number of tags", 0)))
    }

    /** In a binary file elements of one kind and number of tags come in blocks. */
    private fun readBlocks2(count: Int) {
        var left = count
        while (left > 0) {
            val type = scanner.int("an element type", 1)
            val size = scanner.int("the number of elements of the block", 1)
            val tags = scanner.int("the number of tags", 0)
            if (size > left) scanner.fail("a block of $size elements where $left are left")
            repeat(size) {
                scanner.int("an element id", 1)
                readNodesOf(type, readGroup2(tags))
            }
            left -= size
        }
    }

    private fun readGroup2(tagCount: Int): Int {
        var group = 0
        for (i in 0 until tagCount) {
            val tag = scanner.int("a tag", Int.MIN_VALUE)
            if (i == 0) group = Math.abs(tag)
        }
        return group
    }

    private fun readNodesOf(type: Int, group: Int) {
        when (type) {
            MeshContents.LINE -> {
                val a = readNode()
                contents.addLine(a, readNode(), group)
            }
            MeshContents.TRIANGLE -> {
                val a = readNode()
                val b = readNode()
                contents.addTriangle(a, b, readNode(), group)
            }
            MeshContents.QUADRATIC_LINE -> {
                val a = readNode()
                contents.addLine(a, readNode(), group)
                readNode()
            }
            MeshContents.QUADRATIC_TRIANGLE -> {
                val a = readNode()
                val b = readNode()
                contents.addTriangle(a, b, readNode(), group)
                val middle = readNode()
                val next = readNode()
                contents.addMiddles(middle, next, readNode())
            }
            MeshContents.POINT -> contents.addPoint(readNode(), group)
            else -> scanner.fail("elements of type $type cannot be read, only points (15), lines (1, 8) and triangles (2, 9)")
        }
    }

    private fun readNode(): Int = contents.nodeOf(scanner.size("a node id", 1))

    private fun readEntities() {
        val counts = IntArray(4) { scanner.size("a number of entities", 0) }
        for (dimension in 0..3) repeat(counts[dimension]) { readEntity(dimension) }
        scanner.endBinary()
        scanner.expect("\$EndEntities")
    }

    private fun readEntity(dimension: Int) {
        val tag = scanner.int("an entity", Int.MIN_VALUE)
        repeat(if (dimension == 0) 3 else 6) { scanner.double("a coordinate of an entity") }
        repeat(scanner.size("the number of physical groups", 0)) { i ->
            val group = Math.abs(scanner.int("a physical group", Int.MIN_VALUE))
            if (i == 0) entityGroups[key(dimension, tag)] = group
        }
        if (dimension > 0) repeat(scanner.size("the number of bounding entities", 0)) { scanner.int("a bounding entity", Int.MIN_VALUE) }
    }

    private fun readNodes4() {
        val blocks = scanner.size("the number of node blocks", 0)
        contents.expectNodes(scanner.count("the number of nodes"))
        repeat(2) { scanner.size("a node id", 0) }
        repeat(blocks) {
            val dimension = scanner.int("a dimension", 0)
            scanner.int("an entity", Int.MIN_VALUE)
            val parameters = if (scanner.int("the parametric flag", 0) == 0) 0 else dimension
            val count = scanner.count("the number of nodes of the block")
            val nodes = IntArray(count) { contents.addNode(scanner.size("a node id", 1)) }
            for (node in nodes) {
                readPlace(node)
                repeat(parameters) { scanner.double("a parameter") }
            }
        }
        contents.closeNodes()
        scanner.endBinary()
        scanner.expect("\$EndNodes")
    }

    private fun readElements4() {
        val blocks = scanner.size("the number of element blocks", 0)
        repeat(3) { scanner.size("a number of elements or an element id", 0) }
        repeat(blocks) {
            val dimension = scanner.int("a dimension", 0)
            val entity = scanner.int("an entity", Int.MIN_VALUE)
            val type = scanner.int("an element type", 1)
            val group = entityGroups[key(dimension, entity)] ?: 0
            repeat(scanner.size("the number of elements of the block", 0)) {
                scanner.size("an element id", 1)
                readNodesOf(type, group)
            }
        }
        scanner.endBinary()
        scanner.expect("\$EndElements")
    }

    private fun key(dimension: Int, tag: Int): Long = (dimension.toLong() shl 32) or (tag.toLong() and 0xFFFFFFFFL)

    companion object {
        /**
         * @param source name of the file, for messages.
         * @throws org.trigrid.diagnostics.FileFormatException with line and column; in binary parts with the byte.
         */
        fun read(bytes: ByteArray, source: String): ReadMesh = MshReader(MshScanner(bytes, source)).read()
    }
}
