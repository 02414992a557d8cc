package org.trigrid.io

import org.trigrid.diagnostics.FileFormatException

/**
 * AutoCAD's DXF, ASCII: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE with bulges, SPLINE, and INSERT of blocks with them.
 * Pieces whose ends meet are joined to closed loops; the layer is the tag.
 */
internal class DxfFormat : DomainFormat("dxf", "DXF", listOf(".dxf"), hasCurves = true) {
    override val isOfAnyCharset: Boolean get() = true

    override fun looksLike(first: String) = first == "0"

    override fun read(input: DomainText): List<NamedDomain> {
        ReadingMemory.check(input.source, input.text.length, ReadingMemory.DRAWING * input.text.length)
        val pairs = DxfPairs(input.text, input.source)
        val pieces = DxfReader(pairs, input.unit).read()
        val outline = Outline(input, input.baseName)
        OutlineJoining(pieces, input.join, pairs).addTo(outline)
        if (outline.isEmpty) pairs.fail("there is no closed outline in it")
        return input.single(outline.toDomain())
    }
}

/** The pairs of a group code and a value that a DXF file is made of, each on a line of its own. */
internal class DxfPairs(text: String, private val source: String) : Complaint {
    private val lines = text.lines()
    private var at = 0
    var code = 0
        private set
    var value = ""
        private set

    /** Of the pair at hand, from 1. */
    val lineNumber: Int get() = Math.max(at - 1, 1)

    init {
        if (text.startsWith("AutoCAD Binary DXF")) fail("binary DXF cannot be read, only ASCII")
    }

    val isAtEnd: Boolean get() = at + 1 >= lines.size

    /** Goes on to the next pair; false at the end. */
    fun next(): Boolean {
        if (isAtEnd) return false
        code = lines[at].trim().toIntOrNull() ?: failAtLine(at + 1, "expected a group code, found '${lines[at].trim()}'")
        value = lines[at + 1].trim()
        at += 2
        return true
    }

    /** Goes on to the next entity, from one that was not understood; false at the end. */
    fun toNextEntity(): Boolean {
        while (next()) if (code == 0) return true
        return false
    }

    fun number(): Double {
        val number = RingPoints.decimal(value)
        if (number.isNaN()) failAtLine(at, "'$value' is not a number")
        return number
    }

    fun int(): Int = value.toIntOrNull() ?: failAtLine(at, "'$value' is not a whole number")

    override fun fail(reason: String): Nothing = failAtLine(lineNumber, reason)

    fun failAtLine(line: Int, reason: String): Nothing =
        throw FileFormatException(source, line, 0, reason)
}
