package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException
import java.io.ByteArrayInputStream
import java.io.InputStreamReader
import java.io.SequenceInputStream

/**
 * Reads triangles and lines of a `.vtu` file of one piece, its arrays ASCII, inline or appended, base64 or raw, plain or
 * compressed by zlib. Lines get the groups of the cell array `tag`, triangles the region of `region`, as [VtuFormat] writes them.
 */
internal class VtuReader private constructor(private val bytes: ByteArray, private val source: String) {
    private val appendedAt = indexOf(bytes, APPENDED)
    private val xml = XmlWalk(InputStreamReader(xmlPart(), Charsets.UTF_8), source)
    private val coding = VtuCoding()
    private val arrays = HashMap<String, VtuArray>()
    private var pieces = 0

    private fun read(): ReadMesh {
        var section = ""
        loop@ while (true) {
            when (xml.next()) {
                XmlWalk.Event.START -> {
                    if (xml.depth == 1) readRoot()
                    if (xml.name in SECTIONS) section = xml.name
                    if (xml.name == "Piece" && ++pieces > 1) xml.fail("files of several pieces cannot be read")
                    if (xml.name == "DataArray") readArray(section)
                    if (xml.name == "AppendedData") readAppended()
                }
                XmlWalk.Event.DONE -> break@loop
                else -> Unit
            }
        }
        return toMesh()
    }

    /** The text up to the appended numbers, which need not be XML, closed. */
    private fun xmlPart(): java.io.InputStream {
        if (appendedAt < 0) return ByteArrayInputStream(bytes)
        val end = bytes.indexOf('>'.code.toByte(), appendedAt)
        if (end < 0) return ByteArrayInputStream(bytes)
        return SequenceInputStream(
            ByteArrayInputStream(bytes, 0, end + 1), ByteArrayInputStream("</AppendedData></VTKFile>".toByteArray()),
        )
    }

    private fun readRoot() {
        if (xml.name != "VTKFile" || xml.attribute("type") != "UnstructuredGrid") xml.fail("this is no VTK file of an unstructured grid")
        coding.isBigEndian = xml.attribute("byte_order") == "BigEndian"
        coding.headerBytes = when (val type = xml.attribute("header_type")) {
            null, "UInt32" -> Int.SIZE_BYTES
            "UInt64" -> Long.SIZE_BYTES
            else -> xml.fail("the header type $type is unknown")
        }
        coding.isCompressed = when (val compressor = xml.attribute("compressor")) {
            null, "" -> false
            "vtkZLibDataCompressor" -> true
            else -> xml.fail("data compressed by $compressor cannot be read, only by vtkZLibDataCompressor")
        }
    }

    private fun readArray(section: String) {
        val name = xml.attribute("Name").orEmpty()
        val format = xml.attribute("format") ?: "ascii"
        val array = VtuArray(xml.placed(), xml.attribute("type").orEmpty(), format, xml.attribute("offset"))
        if (format != "appended") array.text = textOfElement()
        arrays[if (section == "Points") section else "$section/$name"] = array
    }

    private fun textOfElement(): String {
        val text = StringBuilder()
        val depth = xml.depth
        // VTK puts elements with keys of its own in some arrays.
        do {
            val event = xml.next()
            if (event == XmlWalk.Event.TEXT && xml.depth == depth) text.append(xml.text)
        } while (xml.depth >= depth)
        return text.toString()
    }

    private fun readAppended() {
        coding.isRaw = when (val encoding = xml.attribute("encoding")) {
            "raw" -> true
            null, "base64" -> false
            else -> xml.fail("the encoding $encoding is unknown")
        }
        val from = bytes.indexOf('_'.code.toByte(), bytes.indexOf('>'.code.toByte(), appendedAt))
        if (from < 0) xml.fail("appended data must begin with _")
        coding.appended = bytes
        coding.appendedStart = from + 1
    }

    private fun toMesh(): ReadMesh {
        val points = numbers("Points")
        val connectivity = numbers("Cells/connectivity")
        val offsets = numbers("Cells/offsets")
        val types = numbers("Cells/types")
        val place = arrays.getValue("Cells/types").complaint
        if (points.size % 3 != 0) arrays.getValue("Points").complaint.fail("points must have three coordinates each")
        if (offsets.size != types.size) place.fail("${types.size} types for ${offsets.size} cells")
        val contents = MeshContents(place, "tag_", "region_")
        readNames(contents, "FieldData/tag_names", 0)
        readNames(contents, "FieldData/tag_names", 1)
        readNames(contents, "FieldData/region_names", 2)
        contents.expectNodes(points.size / 3)
        for (node in 0 until points.size / 3) {
            contents.place(contents.addNode(node), points[3 * node], points[3 * node + 1], points[3 * node + 2])
        }
        contents.closeNodes()
        val tags = optionalNumbers("CellData/tag", types.size)
        val regions = optionalNumbers("CellData/region", types.size)
        var from = 0
        for (cell in types.indices) {
            val to = offsets[cell]
            if (!(to >= from && to <= connectivity.size)) place.fail("cell $cell ends at $to of ${connectivity.size} nodes")
            val nodes = IntArray(to.toInt() - from) { contents.nodeOf(whole(connectivity[from + it], place)) }
            val expected = when (types[cell].toInt()) {
                VtuFormat.VTK_VERTEX -> 1
                VtuFormat.VTK_LINE -> 2
                VtuFormat.VTK_TRIANGLE, VtuFormat.VTK_QUADRATIC_EDGE -> 3
                VtuFormat.VTK_QUADRATIC_TRIANGLE -> 6
                else -> place.fail("cells of type ${types[cell].toInt()} cannot be read, only lines (3, 21) and triangles (5, 22)")
            }
            if (nodes.size != expected) place.fail("cell $cell has ${nodes.size} nodes, not $expected")
            val isLine = expected == 2 || types[cell].toInt() == VtuFormat.VTK_QUADRATIC_EDGE
            if (expected == 1) contents.addPoint(nodes[0], group(tags, cell))
            if (isLine) contents.addLine(nodes[0], nodes[1], group(tags, cell))
            else if (expected >= 3) contents.addTriangle(nodes[0], nodes[1], nodes[2], group(regions, cell))
            if (expected == 6) contents.addMiddles(nodes[3], nodes[4], nodes[5])
            from = to.toInt()
        }
        return contents.toMesh()
    }

    private fun whole(value: Double, place: Complaint): Int {
        val number = value.toInt()
        if (number.toDouble() != value || number < 0) place.fail("$value is no number of a node")
        return number
    }

    private fun group(groups: DoubleArray?, cell: Int): Int = if (groups == null) 0 else Math.max(groups[cell].toInt(), 0)

    private fun readNames(contents: MeshContents, array: String, dimension: Int) {
        val found = arrays[array] ?: return
        val text = coding.numbers(found).let { codes -> String(ByteArray(codes.size) { codes[it].toInt().toByte() }, Charsets.UTF_8) }
        text.split('\n').forEachIndexed { i, name -> if (name.isNotEmpty()) contents.putName(dimension, i + 1, name) }
    }

    private fun numbers(name: String): DoubleArray =
        coding.numbers(arrays[name] ?: throw FileFormatException(source, 1, 0, "there is no array ${name.substringAfter('/')}"))

    private fun optionalNumbers(name: String, size: Int): DoubleArray? =
        arrays[name]?.let { coding.numbers(it) }?.takeIf { it.size == size }

    companion object {
        private val SECTIONS = listOf("FieldData", "PointData", "CellData", "Points", "Cells")
        private val APPENDED = "<AppendedData".toByteArray()

        /**
         * @param source name of the file, for messages.
         * @throws FileFormatException with line and column; for appended data those of its array.
         */
        fun read(bytes: ByteArray, source: String): ReadMesh = VtuReader(bytes, source).read()

        private fun indexOf(bytes: ByteArray, wanted: ByteArray): Int {
            for (at in 0..bytes.size - wanted.size) {
                if (bytes[at] == wanted[0] && wanted.indices.all { bytes[at + it] == wanted[it] }) return at
            }
            return -1
        }

        private fun ByteArray.indexOf(byte: Byte, from: Int): Int {
            for (at in Math.max(from, 0) until size) if (this[at] == byte) return at
            return -1
        }
    }
}
